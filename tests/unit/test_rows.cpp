#include "core/engine/base/rows.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

using namespace forefront;

TEST_CASE("Rows: each row holds its items in the order in which they were added") {
    std::mt19937 random(7);
    for (const std::size_t rows : {std::size_t{1}, std::size_t{5}, std::size_t{40}}) {
        for (const std::size_t items : {std::size_t{0}, std::size_t{3}, std::size_t{200}}) {
            std::vector<std::pair<std::size_t, std::uint32_t>> added;
            std::vector<std::vector<std::uint32_t>> expected(rows);
            for (std::uint32_t k = 0; k < items; ++k) {
                const std::size_t row = random() % rows;
                added.emplace_back(row, k);
                expected[row].push_back(k);
            }
            const Rows<std::uint32_t> made(rows, [&](const auto &add) {
                for (const auto &[row, item] : added) {
                    add(row, item);
                }
            });
            REQUIRE(made.size() == rows);
            CHECK(made.items().size() == items);
            std::vector<std::uint32_t> all;
            for (std::size_t row = 0; row < rows; ++row) {
                const std::span<const std::uint32_t> here = made[row];
                CHECK(std::vector<std::uint32_t>(here.begin(), here.end()) == expected[row]);
                all.insert(all.end(), here.begin(), here.end());
            }
            CHECK(std::vector<std::uint32_t>(made.items().begin(), made.items().end()) == all);
        }
    }
}

TEST_CASE("Rows: none without rows, and items of a row can be changed") {
    CHECK(Rows<int>().size() == 0);
    Rows<int> none(0, [](const auto &) {});
    CHECK(none.size() == 0);
    CHECK(none.items().empty());
    Rows<int> rows(2, [](const auto &add) {
        add(1, 3);
        add(1, 4);
    });
    CHECK(rows[0].empty());
    rows[1][0] = 8;
    CHECK(rows.items()[0] == 8);
    CHECK(rows.items()[1] == 4);
}
