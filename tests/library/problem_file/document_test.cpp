#include "library/problem_file/document.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

std::string document_error(std::string_view text) {
  return thrown_by([&] { parse_document(text, "f"); });
}

}  // namespace

TEST_CASE("values come with their kinds, texts and lines") {
  const Value root =
      parse_document("a = 'x'\nb = [\n 0.1,\n 2]\n[t]\nc = true\nd.e = 1e-3\nf = {g = 1979-05-27}\n", "f");
  CHECK(root.find("a")->value.text == "x");
  CHECK(root.find("b")->value.items[0].text == "0.1");
  CHECK(root.find("b")->value.items[0].line == 3);
  CHECK(root.find("b")->value.items[1].text == "2");
  CHECK(root.find("b")->value.items[1].line == 4);
  const Value& t = root.find("t")->value;
  CHECK(t.line == 5);
  CHECK(t.find("c")->value.kind == Value::Kind::boolean);
  CHECK(t.find("d")->value.find("e")->value.text == "0.001");
  CHECK(t.find("f")->value.find("g")->value.kind == Value::Kind::date);
  CHECK(t.find("f")->value.find("g")->value.line == 8);
  CHECK(t.find("z") == nullptr);
}

TEST_CASE("a decimal is the shortest that gives the same double") {
  CHECK(parse_document("a = 0.30000000000000004", "f").find("a")->value.text == "0.30000000000000004");
  CHECK(parse_document("a = 0.3000000000000000000001", "f").find("a")->value.text == "0.3");
  CHECK(parse_document("a = 1e300", "f").find("a")->value.text == "1e+300");
  CHECK(parse_document("a = inf", "f").find("a")->value.text == "inf");
}

TEST_CASE("what would exhaust the parser is refused before") {
  std::string dotted = "a";
  for (int k = 0; k < 32; ++k) dotted += ".a";
  CHECK(document_error(dotted + " = 1") == "no error");
  CHECK(document_error("\n" + dotted + ".a = 1") == "f:2: key too deep; a key has at most 32 parts; more");
  CHECK(document_error("a = " + std::string(32, '[') + std::string(32, ']')) == "no error");
  CHECK(document_error("a = " + std::string(33, '[')) == "f:1: nested too deep; brackets nest at most 32 deep; more");
  std::string many = "a = [";
  for (int k = 0; k < 200000; ++k) many += "1,\n";
  CHECK(document_error(many + "]") ==
        "f:199999: too many values; a problem file has at most 200000 keys and values; more");
}

TEST_CASE("dots, brackets and commas in strings and comments do not count") {
  const std::string dots(100, '.');
  const std::string brackets(100, '[');
  CHECK(document_error("a = '" + dots + brackets + "'") == "no error");
  CHECK(document_error("a = \"\\\"" + dots + brackets + "\"") == "no error");
  CHECK(document_error("# it's " + dots + brackets + "\na = 1") == "no error");
  CHECK(document_error("a = \"\"\"\n'\\\"\"\"" + dots + brackets + "\"\"\"") == "no error");
  CHECK(document_error("a = '''\n\"" + dots + brackets + "'''") == "no error");
  CHECK(document_error("a = '" + dots + "'\nb = " + std::string(33, '[')) ==
        "f:2: nested too deep; brackets nest at most 32 deep; more");
}

TEST_CASE("a long string may end in quotes of its own") {
  const Value root = parse_document("a = \"\"\"x\"\"\"\"\"\nb = '''y''''\n# é\nc = \"é\"\n", "f");
  CHECK(root.find("a")->value.text == "x\"\"");
  CHECK(root.find("b")->value.text == "y'");
  CHECK(root.find("c")->value.text == "é");
  CHECK(root.find("c")->value.line == 4);
}

TEST_CASE("characters beyond ASCII stay what they are in strings, are free in comments, and stand nowhere else") {
  const Value root = parse_document("\xef\xbb\xbf# → é 😀 \"\na = \"→ é 😀 \\\" é\"\nb = \"\"\"\né \\\n  é\"\"\"\n", "f");
  CHECK(root.find("a")->value.text == "→ é 😀 \" é");
  CHECK(root.find("b")->value.text == "é é");
  const std::string rule = "; characters beyond ASCII stand in comments and in \"strings\"; ";
  CHECK(document_error("\n é = 1") == "f:2: unexpected character" + rule + "'é'");
  CHECK(document_error("a = 1\"é\"") != "no error");
  CHECK(document_error("a = 'é'") == "f:1: unexpected character" + rule + "'é'");
  CHECK(document_error("a = \"\\é\"") == "f:1: unexpected character" + rule + "'é'");
  CHECK(document_error("# \xff") == "f:1: not UTF-8; a problem file is encoded in UTF-8; '\\xff'");
  CHECK(document_error("a = \"\n\xc3\"") == "f:2: not UTF-8; a problem file is encoded in UTF-8; '\\xc3'");
}

TEST_CASE("arbitrary text gives a document or a failure") {
  REQUIRE(rc::check([](const std::string& text) { RC_ASSERT(document_error(text) != ""); }));
  const std::string alphabet = "a.=[]{}\"'#,1\n\\ -";
  REQUIRE(rc::check([&] {
    const auto indices = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, static_cast<int>(alphabet.size())));
    std::string text;
    for (const int k : indices) text += k % 8 == 7 ? "é" : std::string(1, alphabet[static_cast<std::size_t>(k)]);
    RC_ASSERT(document_error(text) != "");
  }));
}
