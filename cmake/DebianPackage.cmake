# `cpack -G DEB` in a build folder: the Debian packages pliant (program, cases, documentation) and
# libpliant-dev (library and headers). What the program depends on is read from what it is linked to.

# What does not say otherwise belongs to the program.
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME pliant)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpliant-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The authors of pliant <noreply@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "particle solver for elastic solids and soft tissue")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Simulates elastic solids and soft tissue with particles: large deformation, contact, cutting.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The library behind pliant, with headers and CMake targets.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libtbb-dev, libhdf5-dev, libfmt-dev, libmuparser-dev, libtomlplusplus-dev")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
include(CPack)
