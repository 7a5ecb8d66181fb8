// Four threads make rows of one table, with numbers of both kinds. Each row equals the row that one thread makes. The
// thread sanitizer checks for data races (preset tsan).

#include <thread>

#include "app/process.hpp"
#include "app/sweep/ordered_tasks.hpp"
#include "app/sweep/sweep_table.hpp"
#include "support/test.hpp"

using namespace steadyslide::app;
using namespace steadyslide::testing;

TEST_CASE("four threads make the same rows as one") {
  for (const std::string digits : {"16", "40"}) {
    const TemporaryFolder folder{
        {"sweep.toml",
         "[problem]\nload = 1\n[problem.half_space]\npoisson = 0.2\n[problem.friction]\nvalues = [0.1, 0.5]\n"
         "jumps = [0]\n[problem.indenter]\nprofile = 0\n[vary]\nindenter.profile = [0, \"x^2\"]\n"
         "\"friction.values[0]\" = \"0:0.2:0.1\"\nfriction.jumps = [[0], [2]]\n[solve]\ndigits = " +
             digits + "\n"}};
    const SweepTable table(read_sweep((folder.path() / "sweep.toml").string()));
    REQUIRE(table.size() == 12);
    std::vector<std::string> rows(table.size());
    {
      std::vector<std::thread> threads;
      for (std::size_t first = 0; first < 4; ++first) {
        threads.emplace_back([&, first] {
          for (std::size_t n = first; n < rows.size(); n += 4) rows[n] = table.row(n);
        });
      }
      for (std::thread& thread : threads) thread.join();
    }
    std::vector<std::string> in_turn;
    in_order(
        {0, table.size()}, 4, [&](std::size_t n) { return table.row(n); },
        [&](std::size_t, const std::string& row) { in_turn.push_back(row); });
    CHECK(in_turn == rows);
    for (std::size_t n = 0; n < rows.size(); ++n) {
      CHECK(rows[n] == table.row(n));
      CHECK(is_failed(rows[n]) == (n % 2 == 1));
    }
  }
}
