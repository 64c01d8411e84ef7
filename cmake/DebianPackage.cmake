# `cpack -G DEB` in a build folder makes the Debian packages pliant (program, cases, documentation),
# libpliant-dev (library and headers), and python3-pliant if the Python package is built.
# Dependencies of the program are determined from its linked libraries.

# Files belong to the program unless assigned otherwise.
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
if(PLIANT_PYTHON)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  list(APPEND CPACK_COMPONENTS_ALL python_of_debian)
  set(CPACK_DEBIAN_PYTHON_OF_DEBIAN_PACKAGE_NAME python3-pliant)
  set(CPACK_DEBIAN_PYTHON_OF_DEBIAN_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_OF_DEBIAN_DESCRIPTION "Python package to run pliant step by step and to read its results.")
  set(CPACK_DEBIAN_PYTHON_OF_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_OF_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy, python3-h5py")
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
include(CPack)
