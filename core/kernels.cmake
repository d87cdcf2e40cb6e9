# Code that is compiled once per instruction set.

# The instruction sets of this architecture, the number of doubles side by side in each, and how to ask for it.
# Never -mfma and never -march=native: a fused multiply-add changes results.
option(MORULA_PORTABLE "Leave the AVX kernels out: only what every machine of the architecture has" OFF)
set(MORULA_ISAS scalar narrow)
set(MORULA_WIDTH_scalar 1)
set(MORULA_WIDTH_narrow 2)  # SSE2 on x86-64, NEON on aarch64: what every machine has
if(EMSCRIPTEN)
  set(MORULA_OPTIONS_narrow -msimd128)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT MORULA_PORTABLE)
  target_compile_definitions(morula_flags INTERFACE MORULA_WITH_AVX)
  list(APPEND MORULA_ISAS avx2 avx512)
  set(MORULA_WIDTH_avx2 4)
  set(MORULA_OPTIONS_avx2 -mavx2)
  set(MORULA_WIDTH_avx512 8)
  set(MORULA_OPTIONS_avx512 -mavx512f -mavx512vl -mavx512dq -mprefer-vector-width=512)
endif()
# The number of floats: a block has eight lanes, so wider registers stay half empty.
set(MORULA_SINGLE_WIDTH_scalar 1)
set(MORULA_SINGLE_WIDTH_narrow 4)
set(MORULA_SINGLE_WIDTH_avx2 8)
set(MORULA_SINGLE_WIDTH_avx512 8)

# Every *_kernels.cpp of a folder goes into the target once per instruction set, each into a namespace of its own
# (core/base/isa.h).
function(morula_kernels target folder)
  file(GLOB kernels CONFIGURE_DEPENDS ${folder}/*_kernels.cpp)
  if(NOT kernels)
    return()
  endif()
  foreach(isa ${MORULA_ISAS})
    morula_kernels_for(${target} ${isa} ${isa} "${kernels}" MORULA_WIDTH=${MORULA_WIDTH_${isa}})
  endforeach()
endfunction()

# The same with floats instead of doubles, into namespaces of their own (avx2_single): the files named.
function(morula_single_kernels target)
  foreach(isa ${MORULA_ISAS})
    morula_kernels_for(${target} ${isa} ${isa}_single "${ARGN}" MORULA_WIDTH=${MORULA_SINGLE_WIDTH_${isa}} MORULA_SINGLE)
  endforeach()
endfunction()

function(morula_kernels_for target isa namespace kernels)
  set(objects ${target}_${namespace})
  add_library(${objects} OBJECT ${kernels})
  set_target_properties(${objects} PROPERTIES UNITY_BUILD OFF)
  target_include_directories(${objects} PUBLIC ${morula_SOURCE_DIR}/core
                             $<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(${objects} PUBLIC morula_flags)
  target_compile_definitions(${objects} PRIVATE MORULA_ISA=${namespace} ${ARGN})
  # Kernels are long chains of few branches: scheduled before registers are given out they take 2 to 4 % less time. And gcc
  # 12 misreads its own vector intrinsics.
  target_compile_options(${objects} PRIVATE ${MORULA_OPTIONS_${isa}} -fno-math-errno -fno-trapping-math
    $<$<CXX_COMPILER_ID:GNU>:-fschedule-insns;-fsched-pressure;-Wno-maybe-uninitialized>)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}>)
  if(target MATCHES "^core_")
    set_property(GLOBAL APPEND PROPERTY MORULA_CORE_OBJECTS $<TARGET_OBJECTS:${objects}>)
  endif()
endfunction()
