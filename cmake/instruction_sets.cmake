# The pair loops, the loops over particles and the measurement of the peak rate, once per instruction set; instruction_set.cpp chooses at start.

set(RIFFLE_INSTRUCTION_SETS baseline avx2 avx512)
set(RIFFLE_FLAGS_baseline "")
set(RIFFLE_FLAGS_avx2 -march=x86-64-v3 -mtune=generic)
# GCC 12 warns about its own AVX-512 headers (bug 105593).
set(RIFFLE_FLAGS_avx512 -march=x86-64-v4 -mtune=generic -Wno-uninitialized -Wno-maybe-uninitialized)

foreach(set IN LISTS RIFFLE_INSTRUCTION_SETS)
  add_library(riffle_sph_${set} OBJECT ${PROJECT_SOURCE_DIR}/src/sph/pair_loops_isa.cpp
    ${PROJECT_SOURCE_DIR}/src/sph/particle_loops_isa.cpp ${PROJECT_SOURCE_DIR}/src/sph/peak_rate_isa.cpp)
  set_target_properties(riffle_sph_${set} PROPERTIES UNITY_BUILD OFF)  # two cores share them
  target_link_libraries(riffle_sph_${set} PRIVATE riffle_options)
  target_compile_definitions(riffle_sph_${set} PRIVATE RIFFLE_ISA=${set})
  # -O3 in every build type: the loops are unusable without it, and they are tested against plain sums.
  target_compile_options(riffle_sph_${set} PRIVATE -O3 ${RIFFLE_FLAGS_${set}})
  target_sources(riffle_sph PRIVATE $<TARGET_OBJECTS:riffle_sph_${set}>)
endforeach()
