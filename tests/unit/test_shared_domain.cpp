#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/domain/shared_domain.hpp"

#include <doctest/doctest.h>

#include <array>
#include <thread>
#include <vector>

using namespace forefront;

TEST_CASE("Shared domain: threads that ask at the same time get the one domain of the document") {
    Domain square;
    square.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    const auto document = std::make_shared<const Document>(fromDomain(square));
    SharedDomain shared(document);
    std::array<std::shared_ptr<const Domain>, 4> got;
    {
        std::vector<std::jthread> threads;
        for (auto &one : got) {
            threads.emplace_back([&shared, &one] { one = shared.get(); });
        }
    }
    for (const auto &one : got) {
        REQUIRE(one);
        CHECK(one == got.front());
    }
    CHECK(got.front()->nodes == toDomain(*document).nodes);
    CHECK(shared.document() == document);
}
