# Configurations that must give equal bits: the rows of the matrix (matrix.sh).
#
#   configuration NAME BUILD SCENES COMMAND...
#
# BUILD: ordinary, or one of build_as.sh's. SCENES: all; shorter: without the scene that takes minutes; short: also
# without the one of half a minute, if that would take an hour; quick: without many steps of many cells. COMMAND:
# `morula` and `run_scene` stand for the build's programs. run_scene is the simulator alone, for machines without
# morula's libraries and for builds that differ only in arithmetic.

configuration "as it is" ordinary all morula
for isa in scalar narrow avx2 avx512; do configuration "instruction set $isa" ordinary shorter morula --isa $isa; done
configuration "2 threads" ordinary all morula --threads 2
for threads in 3 7 16; do configuration "$threads threads" ordinary shorter morula --threads $threads; done
configuration "addresses not random" ordinary shorter setarch -R morula
configuration "C library without FMA" ordinary shorter env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F morula
configuration "a German locale" ordinary shorter env "LOCPATH=$work/locales" LC_ALL=de_DE.UTF-8 morula
configuration "a heap full of rubbish" ordinary shorter env MALLOC_PERTURB_=165 morula
configuration "YAML keys in reverse" ordinary shorter env -C "$work/reversed" morula
# Saving and restoring midway would be a line here.

# Whole programs are built by another compiler, without optimisation, and for the smallest instruction set, because
# numbers are also read and results hashed. Each takes minutes to build; other flags use the simulator alone.
configuration "gcc -O0" gcc-O0 short morula
configuration "clang -O2" clang-O2 all morula
configuration "baseline x86-64" gcc-O3-portable shorter morula
configuration "gcc -O2" gcc-O2 shorter run_scene
configuration "gcc -O3" gcc-O3 shorter run_scene
configuration "everything with AVX2" gcc-O2-avx2 shorter run_scene
configuration "everything with AVX-512" gcc-O2-avx512 shorter run_scene
for isa in scalar narrow; do configuration "aarch64, $isa" aarch64-O2 quick qemu-aarch64 run_scene --isa $isa; done
for isa in scalar narrow; do configuration "WebAssembly, $isa" wasm-O3 shorter node run_scene --isa $isa; done
