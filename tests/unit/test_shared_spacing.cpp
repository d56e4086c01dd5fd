#include "core/engine/domain/add_loop.hpp"
#include "core/engine/spacing/shared_spacing.hpp"
#include "tests/support/random_curves.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

using namespace forefront;
using namespace forefront::testing;

namespace {

Domain sharedSquare() {
    Domain domain;
    addLoop(domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    return domain;
}

SpacingSpec sized(double size) {
    SpacingSpec spec;
    spec.size = size;
    return spec;
}

using Field = Result<std::shared_ptr<const SpacingField>>;

} // namespace

TEST_CASE("SharedSpacing: all threads get the same field, that of the specification") {
    const Domain domain = sharedSquare();
    SpacingSpec spec;
    spec.expression = "0.1 + 0.05*x*y";
    spec.gradation = 0.3;
    SharedSpacing shared;
    std::vector<std::shared_ptr<const SpacingField>> fields(8);
    {
        std::vector<std::jthread> threads;
        for (auto &field : fields) {
            threads.emplace_back([&] {
                if (const Field got = shared.get(spec, domain)) {
                    field = *got;
                }
            });
        }
    }
    REQUIRE(fields.front());
    for (const auto &field : fields) {
        CHECK(field == fields.front());
    }
    const Field alone = SpacingField::build(spec, domain);
    REQUIRE(alone);
    for (const Vec2 p : {Vec2{0.5, 0.5}, Vec2{3, 1}, Vec2{4, 4}}) {
        CHECK(fields.front()->at(p) == (*alone)->at(p));
    }
}

TEST_CASE("SharedSpacing: faults are reported to every thread") {
    const Domain domain = sharedSquare();
    SharedSpacing shared;
    for (int i = 0; i < 2; ++i) {
        const Field field = shared.get(sized(-1.0), domain);
        REQUIRE_FALSE(field);
        CHECK(field.faults().front().code == "bad-size");
    }
}

TEST_CASE("SharedSpacing: a cancelled thread leaves building to the next one") {
    const Domain domain = sharedSquare();
    SharedSpacing shared;
    std::stop_source stop;
    stop.request_stop();
    const Field none = shared.get(sized(1.0), domain, {.report = {}, .stop = stop.get_token()});
    REQUIRE_FALSE(none);
    CHECK(none.faults().front().code == "cancelled");
    const Field field = shared.get(sized(1.0), domain);
    REQUIRE(field);
    CHECK((*field)->at({1, 1}) == 1.0);
}

TEST_CASE("SharedSpacing: a thread that waits can be cancelled, and one that builds leaves it to those that wait") {
    const Domain domain = curvedDomain({{Curve::circle({0, 0}, {1, 0})}}, 1e-6); // measuring it is reported
    const SpacingSpec spec;
    SharedSpacing shared;
    std::stop_source builder, waiter;
    std::atomic<bool> building = false, go = false;
    Field built = error("test", "not called"), waited = built, last = built;
    // The builder stays in its first report until it has been cancelled.
    const Progress held{.report =
                            [&](std::string_view, double) {
                                building = true;
                                building.notify_all();
                                go.wait(false);
                            },
                        .stop = builder.get_token()};
    std::jthread first([&] { built = shared.get(spec, domain, held); });
    building.wait(false);
    std::jthread second([&] { waited = shared.get(spec, domain, {.report = {}, .stop = waiter.get_token()}); });
    waiter.request_stop();
    second.join();
    REQUIRE_FALSE(waited);
    CHECK(waited.faults().front().code == "cancelled");
    std::jthread third([&] { last = shared.get(spec, domain); });
    builder.request_stop();
    go = true;
    go.notify_all();
    first.join();
    third.join();
    REQUIRE(last);
    CHECK((*last)->at({1, 1}) > 0.0);
}
