#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/mesher/front_rules.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/mesher/timeline.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/files/rules/rules_json.hpp"
#include "core/teaching/lesson/lesson_read.hpp"
#include "tests/support/random_domains.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/unit/edit_support.hpp"
#include "tests/unit/io_samples.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace forefront;
using namespace forefront::testing;
using forefront::edit_test::documentOf;
using forefront::edit_test::makeShape;

namespace {

/// A plate with a hole and small elements beside it, so that every rule has an effect.
Document plate() {
    Document document = documentOf(
        {makeShape(ShapeKind::Rectangle, {{0, 0}, {20, 14}}), makeShape(ShapeKind::Circle, {{10, 7}, {12.5, 7}})});
    document.spacing.size = 2.0;
    SizeSource source;
    source.shape = SourceShape::Circle;
    source.a = {10, 7};
    source.radius = 2.5;
    source.size = 0.35;
    source.growth = 0.4;
    document.spacing.sources = {source};
    document.options.method = Method::Classic;
    document.options.improve = ImproveLevel::None;
    return document;
}

/// A value of a rule that differs from its default.
double changedValue(FrontRule rule) {
    switch (rule) {
    case FrontRule::Base:
        return static_cast<double>(BaseRule::Oldest);
    case FrontRule::Seed:
        return 7.0;
    case FrontRule::MinRho:
        return 1.0;
    case FrontRule::MaxRho:
        return 1.5;
    case FrontRule::RhoAtC:
        return 0.0;
    case FrontRule::MinHeight:
        return 1.0;
    case FrontRule::Radius:
        return 0.5;
    case FrontRule::SecondRadius:
        return 0.2;
    case FrontRule::Withdraw:
    case FrontRule::Defer:
        return 0.0;
    case FrontRule::NodeClearance:
    case FrontRule::SegmentClearance:
        return 1.0;
    case FrontRule::ShapeWeight:
    case FrontRule::SpacingWeight:
        return 0.0;
    }
    return 0.0;
}

FrontRules randomRules(RandomSource &random) {
    FrontRules rules;
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        const FrontRuleInfo &info = frontRuleInfo(rule);
        if (random.chance(0.3)) {
            continue; // the default
        }
        if (info.kind != RuleKind::Number) {
            setValue(rules, rule, random.integer(static_cast<int>(info.minimum), static_cast<int>(info.maximum)));
        } else { // the ends are the hardest values
            setValue(rules, rule,
                     random.chance(0.2)   ? info.minimum
                     : random.chance(0.2) ? info.maximum
                                          : random.between(info.minimum, info.maximum));
        }
    }
    return rules;
}

/// Steps through a run, with explanations, and goes back now and then.
std::uint64_t steppedHash(const PreparedJob &prepared, const MeshingOptions &options) {
    Timeline timeline(Mesher::create(prepared.boundary, prepared.spacing, options));
    while (!timeline.complete()) {
        if (timeline.position() % 3 == 0) {
            timeline.mesher().explainNext();
        }
        timeline.forward(1);
        if (timeline.position() % 7 == 0) {
            timeline.back(5);
            timeline.forward(5);
        }
    }
    timeline.forward(timeline.known());
    return meshHash(toMesh(timeline.mesher().state(), *prepared.boundary));
}

std::uint64_t hashOn(const PreparedJob &prepared, MeshingOptions options, GridKind grid) {
    options.grid = grid;
    const auto mesher = Mesher::create(prepared.boundary, prepared.spacing, options);
    mesher->advance(~std::uint64_t{0});
    return meshHash(toMesh(mesher->state(), *prepared.boundary));
}

std::uint64_t hashOf(const Document &document) {
    const Result<MeshingOutcome> outcome = meshDomain(jobOf(document));
    REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
    return meshHash(outcome->mesh);
}

/// Returns the bases of the first advances.
std::vector<AdvanceExplanation> firstAdvances(const Document &document, std::size_t count) {
    const Result<PreparedJob> prepared = prepare(jobOf(document));
    REQUIRE(prepared);
    const auto mesher = Mesher::create(prepared->boundary, prepared->spacing, document.options);
    std::vector<AdvanceExplanation> advances;
    for (; advances.size() < count && !mesher->finished(); mesher->advance(1)) {
        advances.push_back(mesher->explainNext());
    }
    return advances;
}

std::string rulesFault(const std::string &text) {
    const Result<FrontRules> rules = readRulesText(sourceOf(text));
    return rules ? "" : toString(rules.faults().front());
}

} // namespace

TEST_CASE("Rules: each one is described, and its default lies within its bounds") {
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        const FrontRuleInfo &info = frontRuleInfo(rule);
        CAPTURE(std::string(wordOf(rule)));
        CHECK(std::string(info.meaning).ends_with("."));
        CHECK(frontRuleFault(rule, valueOf(FrontRules(), rule)).empty());
        CHECK_FALSE(frontRuleFault(rule, info.maximum + 1.0).empty());
        CHECK_FALSE(frontRuleFault(rule, info.minimum - 1.0).empty());
        CHECK(info.step >= 2);
        CHECK(info.step <= 8);
        FrontRules rules;
        setValue(rules, rule, changedValue(rule));
        CHECK(valueOf(rules, rule) == changedValue(rule));
        CHECK(changedRules(rules) == std::vector{rule});
    }
    CHECK(changedRules(FrontRules()).empty());
    CHECK(changesText(FrontRules()).empty());
    FrontRules rules;
    rules.radius = 2.0;
    rules.defer = false;
    rules.base = BaseRule::Longest;
    CHECK(changesText(rules) ==
          "order of bases longest (default shortest), search radius 2 ρ (default 1.2), deferral off (default on)");
}

TEST_CASE("Rules: every one changes the run") {
    Document document = plate();
    const std::uint64_t before = hashOf(document);
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        CAPTURE(std::string(wordOf(rule)));
        document.options.rules = {};
        std::uint64_t other = before;
        if (rule == FrontRule::Seed) {
            document.options.rules.base = BaseRule::Random;
            other = hashOf(document);
        } else if (rule == FrontRule::SecondRadius ||
                   rule == FrontRule::Defer) { // with the defaults no base is deferred
            document.options.rules.base = BaseRule::Longest;
            document.options.rules.radius = 0.2;
            other = hashOf(document);
        }
        setValue(document.options.rules, rule, changedValue(rule));
        CHECK(hashOf(document) != other);
    }
    document.options.rules = {};
    CHECK(hashOf(document) == before);
}

TEST_CASE("Rules: the fast method and quadrilaterals do not use them") {
    Document document = plate();
    document.options.method = Method::Fast;
    const std::uint64_t fast = hashOf(document);
    document.options.elements = Elements::Quads;
    const std::uint64_t quads = hashOf(document);
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        setValue(document.options.rules, rule, changedValue(rule));
    }
    CHECK(hashOf(document) == quads);
    document.options.elements = Elements::Triangles;
    CHECK(hashOf(document) == fast);
}

TEST_CASE("Rules: the order of bases") {
    constexpr std::size_t kSome = 20;
    Document document = plate();
    FrontRules &rules = document.options.rules;
    const auto lengthOf = [](const AdvanceExplanation &advance) { return distance(advance.a, advance.b); };

    rules.base = BaseRule::Longest;
    std::vector<AdvanceExplanation> advances = firstAdvances(document, kSome);
    const Result<PreparedJob> prepared = prepare(jobOf(document));
    REQUIRE(prepared);
    double longest = 0.0;
    for (const DiscreteSegment &s : prepared->boundary->segments) {
        longest = std::max(longest, distance(prepared->boundary->nodes[s.a], prepared->boundary->nodes[s.b]));
    }
    CHECK(lengthOf(advances[0]) == longest);
    CHECK(caption(advances[0], 0).find("longest segment") != std::string::npos);

    rules.base = BaseRule::Oldest;
    advances = firstAdvances(document, kSome);
    for (std::size_t i = 0; i < kSome; ++i) { // the boundary, in its order, unless a segment was used as a side
        const bool ofBoundary = index(advances[i].nodeA) < prepared->boundary->nodes.size() &&
                                index(advances[i].nodeB) < prepared->boundary->nodes.size();
        CHECK(ofBoundary);
        CHECK(caption(advances[i], 0).find("the oldest segment of the front, taken as base AB") != std::string::npos);
        CHECK(advances[i].events.front().equal == 1);
    }

    rules.base = BaseRule::Random;
    advances = firstAdvances(document, kSome);
    CHECK(caption(advances[0], 0).find("a segment of the front drawn at random") != std::string::npos);
    const std::vector<AdvanceExplanation> again = firstAdvances(document, kSome);
    rules.seed = 2;
    const std::vector<AdvanceExplanation> others = firstAdvances(document, kSome);
    std::size_t same = 0;
    for (std::size_t i = 0; i < kSome; ++i) {
        CHECK(again[i].a == advances[i].a);
        same += others[i].a == advances[i].a ? 1U : 0U;
    }
    CHECK(same < kSome / 2);
}

TEST_CASE("Rules: scores of candidates are weighted") {
    FrontRules rules;
    CHECK(rules.score(0.5, 0.25, 0.5) == 0.0625);
    rules.shapeWeight = 2.0;
    CHECK(rules.score(0.5, 0.25, 0.5) == doctest::Approx(0.03125));
    rules.spacingWeight = 0.0;
    CHECK(rules.score(0.5, 0.25, 0.5) == doctest::Approx(0.25));
    rules.shapeWeight = 0.5;
    CHECK(rules.score(-0.5, 0.25, 0.5) == -0.5);

    Document document = plate();
    document.options.rules = rules;
    for (const AdvanceExplanation &advance : firstAdvances(document, 40)) {
        for (const CandidateTrace &candidate : advance.candidates) {
            CHECK(candidate.score == rules.score(candidate.alpha, candidate.deltaAC, candidate.deltaCB));
        }
    }
}

TEST_CASE("Rules: without deferral no base is put back") {
    Document document = plate();
    document.options.rules.base = BaseRule::Longest;
    document.options.rules.radius = 0.2;
    const auto deferred = [&] {
        const std::vector<AdvanceExplanation> advances = firstAdvances(document, 2000);
        return std::count_if(advances.begin(), advances.end(), [](const AdvanceExplanation &a) { return a.deferred; });
    };
    CHECK(deferred() > 0);
    document.options.rules.defer = false;
    CHECK(deferred() == 0);
}

TEST_CASE("Rules: 2,000 random sets close every front with a valid mesh, on every grid, run or stepped") {
    for (std::uint64_t seed = 0; seed < 2000; seed += kSeedStep) {
        CAPTURE(seed);
        RandomSource random(seed);
        MeshingJob job;
        job.domain = randomDomain(seed);
        job.options.method = Method::Classic;
        job.options.improve = ImproveLevel::None;
        job.options.rules = randomRules(random);
        job.options.keepBoundary = seed % 3 == 0;
        if (seed % 5 == 0) {
            job.spacing.size = job.domain.bounds().diagonal() / 20.0;
        }
        CAPTURE(changesText(job.options.rules));
        const Result<MeshingOutcome> outcome = meshDomain(job);
        REQUIRE_MESSAGE(outcome, samples::list(outcome ? Diagnostics{} : outcome.faults()));
        const Diagnostics faults = verifyAgainst(outcome->mesh, *outcome->boundary);
        REQUIRE_MESSAGE(faults.empty(), samples::list(faults));
        if (seed % 20 == 0) {
            const Result<PreparedJob> prepared = prepare(job);
            REQUIRE(prepared);
            const std::uint64_t hash = meshHash(outcome->mesh);
            REQUIRE(steppedHash(*prepared, job.options) == hash);
            for (const GridKind grid : valuesOf<GridKind>()) {
                REQUIRE(hashOn(*prepared, job.options, grid) == hash);
            }
        }
    }
}

TEST_CASE("Rules: files of rules") {
    const Result<FrontRules> rules =
        readRulesText(sourceOf(R"({"base": "random", "seed": 9, "radius": 2, "withdraw": false})"));
    REQUIRE(rules);
    CHECK(rules->base == BaseRule::Random);
    CHECK(rules->seed == 9);
    CHECK(rules->radius == 2.0);
    CHECK_FALSE(rules->withdraw);
    CHECK(rules->defer);
    CHECK(readRulesText(sourceOf("{}")).value() == FrontRules());

    const auto has = [](const std::string &text, const char *part) {
        CAPTURE(text);
        CAPTURE(part);
        CHECK(rulesFault(text).find(part) != std::string::npos);
    };
    has("{\"radius\": 7}", "'radius': expected a number from 0.2 to 5, got 7");
    has("{\n\"seed\": 1.5}", "expected a whole number from 0 to 1000000, got 1.5");
    has("{\n\"seed\": 1.5}", ":2:");
    has("{\"radios\": 1}", "unknown rule 'radios'; expected base, seed, minRho");
    has("{\"base\": \"nearest\"}", "shortest");
    has("{\"withdraw\": 1}", "'withdraw'");
    has("[1]", "expected an object");
    has("{\"radius\": \"2\"}", "expected a number");
}

TEST_CASE("Rules: projects and lessons keep them") {
    Document document = plate();
    CHECK(projectText(document).find("rules") == std::string::npos);
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        setValue(document.options.rules, rule, changedValue(rule));
    }
    const std::string text = projectText(document);
    const Result<Document> read = parseProject(text, "p.json");
    REQUIRE(read);
    CHECK(read->options.rules == document.options.rules);

    LessonNames names;
    names.document = [](const std::string &) -> Result<Document> { return plate(); };
    const auto lesson = readLesson(sourceOf(R"({"format": "forefront-lesson", "version": 1, "title": "T", "pages": [
            {"title": "one", "text": "a", "document": "a.json", "rules": {"base": "oldest"}},
            {"title": "two", "text": "b"}, {"title": "three", "text": "c", "rules": {}}]})"),
                                   names);
    REQUIRE(lesson);
    CHECK(documentOf(lesson->pages[0])->options.rules.base == BaseRule::Oldest);
    CHECK(documentOf(lesson->pages[1])->options.rules.base == BaseRule::Oldest);
    CHECK(documentOf(lesson->pages[2])->options.rules == FrontRules());
}
