# Compiler options of each instruction set.

# GCC 12 takes the undefined register in its own AVX-512 intrinsics for an uninitialised variable.
set(sse2_options)
set(avx2_options -mavx2 -mfma)
set(avx512_options -march=skylake-avx512 -mprefer-vector-width=512 -Wno-uninitialized
                   -Wno-maybe-uninitialized)

# Compiles sources of the calling directory for one instruction set.
function(pliant_compile_for isa)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${${isa}_options}")
endfunction()
