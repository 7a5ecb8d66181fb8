# cmake -D INPUT=FILE -D NAMESPACE=name::space -D NAME=identifier -D OUTPUT=FILE.cpp -P embed.cmake: the file's bytes as
# a text in C++, extern const std::string_view name::space::identifier.
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include <string_view>

namespace ${NAMESPACE} {
namespace {
constexpr unsigned char ${NAME}_bytes[]{${bytes}0};
}
extern const std::string_view ${NAME};
const std::string_view ${NAME}{reinterpret_cast<const char*>(${NAME}_bytes), sizeof ${NAME}_bytes - 1};
}
")
