# The pages of `riffle report`, `riffle watch` and `riffle sweep`: their HTML, style, scripts and figure library become read-only data of the
# binary. The figure library comes from the npm registry at configure time, pinned by web/package-lock.json;
# the assembler takes the files as they are (.incbin), which costs no compile time.

enable_language(ASM)

# riffle_npm_packages(OUT): folder of node modules with the packages of web/package-lock.json.
function(riffle_npm_packages OUT)
  set(folder ${PROJECT_BINARY_DIR}/web)
  set(library ${folder}/node_modules/plotly.js-cartesian-dist-min/plotly-cartesian.min.js)
  set(stamp ${folder}/installed-lock.sha256)
  set(manifest ${PROJECT_SOURCE_DIR}/web/package.json)
  set(lock ${PROJECT_SOURCE_DIR}/web/package-lock.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manifest} ${lock})
  file(SHA256 ${lock} wanted)
  set(installed "")
  if(EXISTS ${stamp} AND EXISTS ${library})
    file(READ ${stamp} installed)
  endif()
  if(NOT installed STREQUAL wanted)
    find_program(RIFFLE_NPM npm DOC "Node package manager, installs the report's figure library")
    if(NOT RIFFLE_NPM)
      message(FATAL_ERROR "npm was not found. It installs the report's figure library (Plotly). "
                          "On Debian: apt-get install npm")
    endif()
    message(STATUS "Installing the report's figure library with npm")
    file(MAKE_DIRECTORY ${folder})
    file(COPY ${manifest} ${lock} DESTINATION ${folder})
    execute_process(
      COMMAND ${RIFFLE_NPM} ci --omit=dev --ignore-scripts --no-audit --no-fund --loglevel=error
      WORKING_DIRECTORY ${folder} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0 OR NOT EXISTS ${library})
      message(FATAL_ERROR "npm could not install the report's figure library "
                          "(plotly.js-cartesian-dist-min, pinned in web/package-lock.json):\n${output}\n"
                          "Check the network and the npm registry (npm config get registry), then configure again.")
    endif()
    file(WRITE ${stamp} ${wanted})
  endif()
  set(${OUT} ${folder}/node_modules PARENT_SCOPE)
endfunction()

# riffle_embed(TARGET symbol=file[,file...]...): add the files, one after the other, to the target as the data
# symbol_begin .. symbol_end.
function(riffle_embed TARGET)
  set(listing ${PROJECT_BINARY_DIR}/generated/${TARGET}_data.s)
  set(text "    .section .rodata\n")
  set(files "")
  foreach(item IN LISTS ARGN)
    string(REGEX MATCH "^([^=]+)=(.+)$" matched "${item}")
    set(symbol ${CMAKE_MATCH_1})
    string(REPLACE "," ";" paths ${CMAKE_MATCH_2})
    string(APPEND text "    .globl ${symbol}_begin\n    .globl ${symbol}_end\n${symbol}_begin:\n")
    foreach(path IN LISTS paths)
      string(APPEND text "    .incbin \"${path}\"\n")
    endforeach()
    string(APPEND text "${symbol}_end:\n    .byte 0\n")
    list(APPEND files ${paths})
  endforeach()
  string(APPEND text "    .section .note.GNU-stack,\"\",%progbits\n")
  file(GENERATE OUTPUT ${listing} CONTENT "${text}")
  set_source_files_properties(${listing} PROPERTIES GENERATED TRUE LANGUAGE ASM OBJECT_DEPENDS "${files}")
  if(CMAKE_ASM_COMPILER_ID MATCHES "Clang")
    set_source_files_properties(${listing} PROPERTIES COMPILE_OPTIONS -Qunused-arguments)
  endif()
  target_sources(${TARGET} PRIVATE ${listing})
endfunction()

# riffle_report_page(TARGET): embed the report's pages.
function(riffle_report_page TARGET)
  get_target_property(type ${TARGET} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    return()
  endif()
  riffle_npm_packages(modules)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(shared "")
  foreach(script elements figures units save page analysis_style analysis_figures analysis_panels chapters)
    list(APPEND shared ${web}/${script}.js)
  endforeach()
  list(JOIN shared "," shared)
  riffle_embed(${TARGET}
    riffle_page_report_html=${web}/page_start.html,${web}/report.html,${web}/page_end.html
    riffle_page_comparison_html=${web}/page_start.html,${web}/comparison.html,${web}/page_end.html
    riffle_page_style=${web}/report.css
    riffle_page_plotly=${modules}/plotly.js-cartesian-dist-min/plotly-cartesian.min.js
    riffle_page_shared=${shared}
    riffle_page_field=${web}/field.js
    riffle_page_moving_surface=${web}/moving_surface.js
    riffle_page_report=${web}/report.js
    riffle_page_comparison=${web}/comparison.js)
endfunction()

# riffle_watch_page(TARGET): embed what the page of `riffle watch` has of its own.
function(riffle_watch_page TARGET)
  set(web ${PROJECT_SOURCE_DIR}/web)
  riffle_embed(${TARGET}
    riffle_watch_html=${web}/watch.html
    riffle_watch_style=${web}/watch.css
    riffle_watch_script=${web}/watch.js)
endfunction()

# riffle_sweep_page(TARGET): embed what the page of `riffle sweep` has of its own.
function(riffle_sweep_page TARGET)
  set(web ${PROJECT_SOURCE_DIR}/web)
  riffle_embed(${TARGET}
    riffle_sweep_html=${web}/page_start.html,${web}/sweep.html,${web}/page_end.html
    riffle_sweep_script=${web}/sweep.js)
endfunction()
