# The pair loops, the loops over particles and the measurement of the peak rate, once per instruction set; instruction_set.cpp chooses at start.

set(RIFFLE_INSTRUCTION_SETS all CACHE STRING
  "Instruction sets that the program holds its inner loops for: all, machine (the best that this machine offers; builds faster), or some of avx512;avx2;baseline")

set(sets ${RIFFLE_INSTRUCTION_SETS})
if(sets STREQUAL "all")
  set(sets avx512 avx2 baseline)
elseif(sets STREQUAL "machine")
  # Asked at each configuration: a folder that several machines share may be built on another one next.
  try_run(RIFFLE_MACHINE_RAN RIFFLE_MACHINE_COMPILED ${PROJECT_BINARY_DIR}/machine
    ${PROJECT_SOURCE_DIR}/cmake/machine_instruction_set.cpp
    CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR}/src RUN_OUTPUT_VARIABLE sets)
  if(NOT RIFFLE_MACHINE_COMPILED OR NOT RIFFLE_MACHINE_RAN EQUAL 0)
    message(FATAL_ERROR "The instruction set of this machine cannot be found; configure with -DRIFFLE_INSTRUCTION_SETS=all")
  endif()
endif()

set(RIFFLE_FLAGS_baseline "")
set(RIFFLE_FLAGS_avx2 -march=x86-64-v3 -mtune=generic)
# GCC 12 warns about its own AVX-512 headers (bug 105593).
set(RIFFLE_FLAGS_avx512 -march=x86-64-v4 -mtune=generic -Wno-uninitialized -Wno-maybe-uninitialized)

set(table "")
foreach(set IN ITEMS avx512 avx2 baseline)  # the best one first
  if(NOT set IN_LIST sets)
    continue()
  endif()
  list(REMOVE_ITEM sets ${set})
  string(APPEND table "    BuiltSet{InstructionSet::${set}, &${set}::loop_table, &${set}::particle_loop_table},\n")
  add_library(riffle_sph_${set} OBJECT ${PROJECT_SOURCE_DIR}/src/sph/pair_loops_isa.cpp
    ${PROJECT_SOURCE_DIR}/src/sph/particle_loops_isa.cpp ${PROJECT_SOURCE_DIR}/src/sph/peak_rate_isa.cpp)
  set_target_properties(riffle_sph_${set} PROPERTIES UNITY_BUILD OFF)  # two cores share them
  target_link_libraries(riffle_sph_${set} PRIVATE riffle_options)
  target_compile_definitions(riffle_sph_${set} PRIVATE RIFFLE_ISA=${set})
  # -O3 in every build type: with -O2 the loops in space take 2.4 times as long, and they are tested against plain sums.
  target_compile_options(riffle_sph_${set} PRIVATE -O3 ${RIFFLE_FLAGS_${set}})
  target_sources(riffle_sph PRIVATE $<TARGET_OBJECTS:riffle_sph_${set}>)
endforeach()
if(sets OR NOT table)
  message(FATAL_ERROR "RIFFLE_INSTRUCTION_SETS=${RIFFLE_INSTRUCTION_SETS}: expected all, machine, or some of avx512;avx2;baseline")
endif()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/riffle_instruction_sets.inc CONTENT "${table}" @ONLY)
