# Every target links `pliant_options`: the language, the warnings, the floating-point contract.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(pliant_options INTERFACE)
target_compile_features(pliant_options INTERFACE cxx_std_20)
target_include_directories(pliant_options INTERFACE ${PROJECT_SOURCE_DIR})
# Contraction is off so that a fused multiply-add happens where the source asks for one and nowhere
# else: AVX2 and AVX-512 then agree to the bit.
target_compile_options(
  pliant_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror -ffp-contract=off)

if(PLIANT_SANITIZE)
  target_compile_options(pliant_options INTERFACE -fsanitize=address,undefined
                                                  -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(pliant_options INTERFACE -fsanitize=address,undefined)
endif()
