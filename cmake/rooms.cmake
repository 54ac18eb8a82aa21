# One static library per folder of src/. A room's unit tests link only the room and the rooms it names, so a call
# into another room fails to link there. All rooms share one include path; tests/check_rooms.py holds the includes
# against the riffle_room lines of CMakeLists.txt.

add_library(riffle_options INTERFACE)
# -Wno-restrict: GCC 12 warns about its own std::string (bug 105651).
target_compile_options(riffle_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wno-restrict -fno-math-errno -fno-trapping-math
  $<$<BOOL:${RIFFLE_WERROR}>:-Werror>)
target_include_directories(riffle_options INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}/generated)
# The presets `release` and `ci` compile several files of a room as one (CMAKE_UNITY_BUILD), which halves the time of
# a build; `debug` compiles each alone and so shows an include that is missing.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
if(CMAKE_UNITY_BUILD)
  # A class of a .cpp file may hold one of its anonymous namespace; GCC takes the file for a header then.
  target_compile_options(riffle_options INTERFACE -Wno-subobject-linkage)
endif()
if(RIFFLE_SANITIZE)
  target_compile_options(riffle_options INTERFACE -fsanitize=${RIFFLE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(riffle_options INTERFACE -fsanitize=${RIFFLE_SANITIZE})
endif()

# HDF5 of the FindHDF5 module, as one target whose headers are system headers.
function(riffle_hdf5_target)
  if(NOT TARGET hdf5)
    add_library(hdf5 INTERFACE)
    target_include_directories(hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
    target_link_libraries(hdf5 INTERFACE ${HDF5_C_LIBRARIES})
  endif()
endfunction()

# riffle_room(NAME [ROOMS room...] [LINK target... | PRIVATE_target...] [EXECUTABLE name])
function(riffle_room NAME)
  cmake_parse_arguments(ROOM "" "EXECUTABLE" "ROOMS;LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${NAME}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_isa\\.cpp$")
  # The parts of SimulationOf: each instantiates the members that it defines.
  set(parts ${sources})
  list(FILTER parts INCLUDE REGEX "/simulation_[a-z]+\\.cpp$")
  set_source_files_properties(${parts} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(ROOM_EXECUTABLE)
    set(target ${ROOM_EXECUTABLE})
    if(NOT sources)
      return()
    endif()
    add_executable(${target} ${sources})
    set(scope PRIVATE)
  else()
    set(target riffle_${NAME})
    if(sources)
      add_library(${target} STATIC ${sources})
      set(scope PUBLIC)
    else()
      add_library(${target} INTERFACE)
      set(scope INTERFACE)
    endif()
  endif()
  target_link_libraries(${target} ${scope} riffle_options)
  foreach(room IN LISTS ROOM_ROOMS)
    target_link_libraries(${target} ${scope} riffle_${room})
  endforeach()
  foreach(item IN LISTS ROOM_LINK)
    if(item MATCHES "^PRIVATE_(.*)$")
      if(CMAKE_MATCH_1 STREQUAL "hdf5")
        riffle_hdf5_target()
      endif()
      if(NOT scope STREQUAL "INTERFACE")
        target_link_libraries(${target} PRIVATE ${CMAKE_MATCH_1})
      endif()
    else()
      target_link_libraries(${target} ${scope} ${item})
    endif()
  endforeach()
endfunction()
