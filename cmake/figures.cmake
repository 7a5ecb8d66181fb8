# cmake -D FOLDER=app/figures/drawings -D OUTPUT=figure_list.cpp -P figures.cmake: the list that app/figures/figures.hpp
# declares, one figure for each function make_NAME() of its sources; those of the paper's first part come first, then alphabetically.
set(names sketch reactions flat_punch friction_jump_rising friction_jump_falling parabola local_forms)
file(GLOB sources "${FOLDER}/*.cpp")
set(found "")
foreach(source IN LISTS sources)
  file(STRINGS "${source}" makers REGEX "^Figure make_[a-z_]+\\(\\) {$")
  list(TRANSFORM makers REPLACE "^Figure make_([a-z_]+).*" "\\1")
  list(APPEND found ${makers})
endforeach()
list(SORT found)
list(APPEND names ${found})
list(REMOVE_DUPLICATES names)

set(declarations "")
set(entries "")
foreach(name IN LISTS names)
  string(REPLACE "_" "-" figure "${name}")
  string(APPEND declarations "Figure make_${name}();\n")
  string(APPEND entries "      {\"${figure}\", make_${name}},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"app/figures/figures.hpp\"

namespace steadyslide::app {

${declarations}
const std::vector<FigureMaker>& figures() {
  static const std::vector<FigureMaker> all{
${entries}  };
  return all;
}

}  // namespace steadyslide::app
")
