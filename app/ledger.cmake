# The ledger's commands: verify, report and figures.
foreach(name IN ITEMS verify figures report)
  steadyslide_embed(ledger_sources ${embedded} help_${name} help/${name}.txt)
endforeach()
foreach(file IN ITEMS tables/preamble.tex ../examples/rough_surface.csv ../docs/mutants.csv ../docs/references.md
             ../docs/theory.md report/page/report.html report/page/tools.html
             report/page/guide.html report/page/report.css report/page/report.js report/page/result.txt
             ../docs/sketch.svg)
  cmake_path(GET file FILENAME name)
  string(MAKE_C_IDENTIFIER ${name} name)
  steadyslide_embed(ledger_sources ${embedded} ${name} ${file})
endforeach()

# The source with the commit is checked at every build, and written if it has changed.
set(commit_source "${CMAKE_CURRENT_BINARY_DIR}/commit.cpp")
set(commit_script ${CMAKE_COMMAND} -D "SOURCE=${PROJECT_SOURCE_DIR}" -D "OUTPUT=${commit_source}"
                  -P "${PROJECT_SOURCE_DIR}/cmake/commit.cmake")
execute_process(COMMAND ${commit_script})
add_custom_target(steadyslide_commit COMMAND ${commit_script} BYPRODUCTS "${commit_source}" VERBATIM)

steadyslide_library(app
  SOURCES "${commit_source}" ${ledger_sources} ${sources}
  PUBLIC steadyslide::app_core steadyslide::proofs_checks
  PRIVATE steadyslide::statements nlohmann_json::nlohmann_json fmt::fmt)
add_dependencies(steadyslide_app steadyslide_commit)
set_source_files_properties("${commit_source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
set_target_properties(steadyslide_app PROPERTIES UNITY_BUILD_BATCH_SIZE 16)

# The tables of docs/theory.md, "Exponents in numbers", in three formats.
steadyslide_executable(exponent-tables SOURCES tables/exponent_tables_main.cpp LIBRARIES steadyslide::app)
set(ledger_programs steadyslide_app exponent-tables)
