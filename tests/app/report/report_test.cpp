#include <csignal>

#include "app/command_line.hpp"
#include "app/report/sections.hpp"
#include "app/report_fixture.hpp"

using namespace steadyslide::app;

TEST_CASE("the page has every statement with its verdict, evidence and controls") {
  const std::string page = report_html(fabricated_result(), fabricated_supplement());
  CHECK(times(page, "<details class=\"claim\"") == 5);
  for (const std::string& part : lines(file_text(STEADYSLIDE_TESTS "/app/report/page.txt"))) {
    CHECK_MESSAGE(holds(page, part), part);
  }
  CHECK(times(page, "<svg") == 3);
  CHECK_FALSE(holds(page, "<!--"));
}

TEST_CASE("texts are escaped, and the page loads no other file") {
  const std::string page = report_html(fabricated_result(), fabricated_supplement());
  CHECK(holds(page, "[Bal16, (1)] &lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK(times(page, "<script") == 1);
  CHECK(holds(page, "<code>1 &lt; %</code>"));
  for (const char* part : {" src=", "@import", "url(http", "<link rel=\"stylesheet\"", "fetch(", "XMLHttpRequest"})
    CHECK_FALSE_MESSAGE(holds(page, part), part);
}

TEST_CASE("parts without content are left out, and so are their entries in the contents") {
  VerifyResult result = fabricated_result();
  result.notes.clear();
  const std::string page = report_html(result, {});
  for (const char* id : {"notes", "figures", "tables", "mutants"}) {
    CAPTURE(id);
    CHECK_FALSE(holds(page, "href=\"#" + std::string(id) + "\""));
    CHECK_FALSE(holds(page, "<section id=\"" + std::string(id) + "\""));
  }
  CHECK(holds(report_html(result, {{}, "No figures: gnuplot is missing.", {}, {}}), "No figures: gnuplot is missing."));
  result.notes_left_out = 3;
  CHECK(holds(report_html(result, {}), "3 notes"));
}

TEST_CASE("the same run gives the same page") {
  CHECK(report_html(fabricated_result(), fabricated_supplement()) ==
        report_html(fabricated_result(), fabricated_supplement()));
}

TEST_CASE("drawings on one page do not share ids") {
  const std::string svg = inline_svg(
      "<?xml version='1.0'?><svg><title>Gnuplot</title><g id=\"a\"/><g id='b'/><use "
      "xlink:href='#a'/><g clip-path=\"url(#b)\"/><script>x</script></svg>\n",
      "one", "A \"curve\"");
  CHECK(svg ==
        "<svg role=\"img\" aria-label=\"A &quot;curve&quot;\"><g id=\"one-a\"/><g id='one-b'/><use "
        "xlink:href='#one-a'/><g clip-path=\"url(#one-b)\"/></svg>");
  CHECK(inline_svg("no drawing", "one", "") == "");
}

TEST_CASE("the numbers of a column are aligned; tables are numbered") {
  std::vector<std::string> cells{"-0.5", "12", "1.25", "blows up"};
  align_numbers(cells);
  CHECK(cells == std::vector<std::string>{"<span class=\"n\">−0.5\u2007</span>",
                                          "<span class=\"n\">12\u2008\u2007\u2007</span>",
                                          "<span class=\"n\">1.25</span>", "blows up"});
  CHECK(with_numbers("a # b # c", "#", "Table") == "a Table 1. b Table 2. c");
}

TEST_CASE("the page gives its date, compiler and libraries") {
  std::map<std::string, std::string> made;
  for (const auto& [part, by] : made_now()) made[part] = by;
  CHECK(made["compiler"] != "");
  CHECK(holds(made["libraries"], "MPFR 4."));
  CHECK(made["date"].starts_with("20"));
}

TEST_CASE("mutants: quoted fields, missing fields, empty lines") {
  const std::vector<Mutant> mutants =
      read_mutants("id,file,change,killer,evidence\r\n\nm-1,a.cpp,\"x, \"\"y\"\"\nz\",t,e\nm-2,b.cpp\n");
  REQUIRE(mutants.size() == 2);
  CHECK(mutants[0].change == "x, \"y\"\nz");
  CHECK(mutants[0].evidence == "e");
  CHECK(mutants[1].id == "m-2");
  CHECK(mutants[1].evidence == "");
  CHECK(read_mutants("id,file,change,killer,evidence\n").empty());
}

TEST_CASE("references: paragraphs with a key become a list, and short tables are left out") {
  const std::string html = references_list(
      "# References\n\ntext\n\n**[A1]** One, *A <title>*,\n[doi:1](https://doi.org/1). More:\n\n| a |\n|---|\n\n"
      "**[B2]** Two.\n");
  CHECK(html ==
        "<dl class=\"references\">\n<dt id=\"ref-A1\">[A1]</dt><dd> One, <em>A &lt;title&gt;</em>, "
        "<a href=\"https://doi.org/1\">doi:1</a>. More:</dd>\n<dt id=\"ref-B2\">[B2]</dt><dd> Two.</dd>\n</dl>\n");
  CHECK(cited_prose("[Bal16, (4)], [Bal] and [Joh85]") ==
        "[<a href=\"#ref-Bal16\">Bal16</a>, (4)], [Bal] and [<a href=\"#ref-Joh85\">Joh85</a>]");
}

TEST_CASE("verify --report writes the page beside its own output, from one run") {
  const TemporaryFolder folder;
  // An empty PATH has no gnuplot, so there are no figures. report_browser_test.cpp tests a page with figures.
  const Arguments verify = words("verify --quick --claim gamma-* --report a/b -o out.txt");
  const Finished finished = run_program_by({"env", "PATH="}, verify, folder.path());
  CHECK(finished.code == 0);
  CHECK(finished.out == "");
  CHECK(holds(folder.read("out.txt"), "2 proved, 0 supported"));
  CHECK(holds(folder.read("a/b/report.html"), "2 proved, 0 supported"));
}

TEST_CASE("a report is refused if its folder cannot be made") {
  const TemporaryFolder folder{{"file", ""}};
  for (const Arguments& arguments :
       {Arguments{"verify", "--claim", "gamma-range", "--report", "file"}, {"report", "-o", "file"}}) {
    const Finished finished = folder.run(arguments);
    CHECK(finished.code == 3);
    CHECK(finished.err.starts_with("steadyslide: file: cannot be made"));
  }
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a signal removes both unfinished files") {
  const TemporaryFolder folder;
  const Finished finished =
      run_and_interrupt({"verify", "--claim", "vi-convergence-*", "--report", ".", "-o", "out.txt"}, folder, SIGINT,
                        std::chrono::milliseconds(300));
  CHECK(finished.code == 130);
  CHECK(folder.names().empty());
}
