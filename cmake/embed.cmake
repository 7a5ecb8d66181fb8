# cmake -D INPUT=FILES -D NAMESPACE=name::space -D NAME=identifier -D OUTPUT=FILE.cpp -P embed.cmake: writes the bytes
# of the files, one file after the other, as a text in C++, extern const std::string_view name::space::identifier.
set(bytes "")
foreach(input IN LISTS INPUT)
  file(READ "${input}" more HEX)
  string(APPEND bytes "${more}")
endforeach()
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
