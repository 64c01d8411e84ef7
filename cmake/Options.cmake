# Every target links `pliant_options`: the language, the warnings, the floating-point contract.
# Warnings become errors through CMAKE_COMPILE_WARNING_AS_ERROR, which the presets set.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)

if(PLIANT_CCACHE)
  find_program(ccache ccache REQUIRED)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ccache})
endif()

add_library(pliant_options INTERFACE)
target_compile_features(pliant_options INTERFACE cxx_std_20)
target_include_directories(pliant_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include
                                                    ${PROJECT_BINARY_DIR}/include)
# Contraction is off so that a fused multiply-add happens where the source asks for one and nowhere
# else: AVX2 and AVX-512 then agree to the bit. __FILE__ is relative, so that a program does not
# depend on where it was built. Nothing replaces functions of the library, so that those of
# position-independent objects may be inlined too.
target_compile_options(
  pliant_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-semantic-interposition
                           -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)

# Sources compiled together see each other's names, and their types belong to an included file.
if(CMAKE_UNITY_BUILD)
  target_compile_options(pliant_options INTERFACE -Wno-shadow -Wshadow=local -Wno-subobject-linkage)
endif()

# Assertions follow the build type: off in Release (NDEBUG), on in the sanitize preset. Warnings are
# the business of the release build: instrumented code makes GCC 12 see uninitialised members and
# mismatched deallocation where there are none. The vptr check is off because oneTBB's flow graph
# casts to a task that it has just destroyed; those of every pointer for null, alignment, size and
# overflow, a quarter of the time to compile, because the address sanitizer and the processor find the same.
# Targets with the property PLIANT_NOT_INSTRUMENTED are left out: instrumenting doubles their time to compile.
if(PLIANT_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr,null,alignment,object-size,pointer-overflow)
  set(instrumented $<NOT:$<BOOL:$<TARGET_PROPERTY:PLIANT_NOT_INSTRUMENTED>>>)
  target_compile_definitions(pliant_options INTERFACE _GLIBCXX_ASSERTIONS)
  target_compile_options(pliant_options INTERFACE "$<${instrumented}:${sanitizers};-fno-sanitize-recover=all>"
                                                  -fno-omit-frame-pointer -w)
  target_link_options(pliant_options INTERFACE ${sanitizers})
endif()
