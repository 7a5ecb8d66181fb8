# cmake -D FOLDER=proofs_checks/claims -D OUTPUT=claim_list.cpp -P claims.cmake: the list that claim_list.hpp declares,
# from the pairs NAME.cpp and NAME.md below FOLDER.
file(GLOB_RECURSE texts RELATIVE "${FOLDER}" "${FOLDER}/*.md")
set(declarations "")
set(entries "")
foreach(text IN LISTS texts)
  cmake_path(GET text STEM name)
  cmake_path(GET text PARENT_PATH group)
  string(REPLACE "_" "-" id "${name}")
  string(REPLACE "_" "-" group "${group}")
  file(READ "${FOLDER}/${text}" document)
  string(APPEND declarations "Claim ${name}();\n")
  string(APPEND entries "    {\"${id}\", \"${group}\", R\"claim(${document})claim\", ${name}},\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"proofs_checks/kit/claim_list.hpp\"

namespace steadyslide::proofs_checks {

${declarations}
std::span<const ClaimEntry> claim_list() {
  static const ClaimEntry all[]{
${entries}  };
  return all;
}

}  // namespace steadyslide::proofs_checks
")
