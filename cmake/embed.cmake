# cmake -D INPUT=FILE -D NAME=identifier -D OUTPUT=FILE.cpp -P embed.cmake: the file's bytes as a text in C++, which
# app/embedded.hpp declares.
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"app/embedded.hpp\"

namespace steadyslide::app::embedded {
namespace {
constexpr unsigned char bytes[]{${bytes}0};
}
const std::string_view ${NAME}{reinterpret_cast<const char*>(bytes), sizeof bytes - 1};
}
")
