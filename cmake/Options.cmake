# Every target links `pliant_options`: language standard, warnings, floating-point rules.
# CMAKE_COMPILE_WARNING_AS_ERROR, which the presets set, turns warnings into errors.

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
# Without contraction, fused multiply-adds happen only where the source requests them: AVX2 and
# AVX-512 then agree to the bit. __FILE__ is relative, so that a program does not depend on its
# build folder. Without semantic interposition, functions in position-independent objects can be
# inlined too.
target_compile_options(
  pliant_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-semantic-interposition
                           -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)

# GCC collects its garbage less often: a twentieth of the compile time, for a fifth more memory.
target_compile_options(
  pliant_options INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param=ggc-min-expand=300 --param=ggc-min-heapsize=400000>")

# Sources compiled together see each other's names, and their types count as those of an included
# file.
if(CMAKE_UNITY_BUILD)
  target_compile_options(pliant_options INTERFACE -Wno-shadow -Wshadow=local -Wno-subobject-linkage)
endif()

# Assertions follow the build type: off in Release (NDEBUG), on in the sanitize preset. Only the
# release build has warnings: with instrumented code GCC 12 reports uninitialised members and
# mismatched deallocation where there are none. The vptr check is off because oneTBB's flow graph
# casts to a task that it has just destroyed. Checks of every pointer for null, alignment, size and
# overflow are off because they take a quarter of the compile time, and the address sanitizer and
# the processor detect the same. Targets with the property PLIANT_NOT_INSTRUMENTED are not
# instrumented: that would double their compile time.
if(PLIANT_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr,null,alignment,object-size,pointer-overflow)
  set(instrumented $<NOT:$<BOOL:$<TARGET_PROPERTY:PLIANT_NOT_INSTRUMENTED>>>)
  target_compile_definitions(pliant_options INTERFACE _GLIBCXX_ASSERTIONS)
  target_compile_options(pliant_options INTERFACE "$<${instrumented}:${sanitizers};-fno-sanitize-recover=all>"
                                                  -fno-omit-frame-pointer -w)
  target_link_options(pliant_options INTERFACE ${sanitizers})
endif()
