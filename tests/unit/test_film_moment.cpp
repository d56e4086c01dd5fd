#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/add_loop.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/film_scene.hpp"
#include "core/teaching/film/pdf_writer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace moment_pictures {

FilmLayers labelled() {
    FilmLayers layers;
    layers.shown[static_cast<std::size_t>(FilmLayer::Labels)] = true;
    return layers;
}

MeshStepper run(Method method) {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    addLoop(job.domain, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, 2);
    job.spacing.size = 0.7;
    job.options.method = method;
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job));
    REQUIRE(stepper);
    return *std::move(stepper);
}

FilmScene sceneAt(MeshStepper &stepper, std::uint64_t advance) {
    stepper.seek(advance);
    const FilmSheet sheet{stepper.mesh().bounds(), 800};
    return sceneOf(*stepper.snapshot(labelled().needed()), sheet, labelled(), stepper.known());
}

std::vector<FilmText> named(const FilmScene &scene, const std::string &name) {
    std::vector<FilmText> found;
    std::copy_if(scene.texts.begin(), scene.texts.end(), std::back_inserter(found),
                 [&](const FilmText &text) { return text.place && text.text == name; });
    return found;
}

Box2 boxOf(const FilmText &text) {
    return {{text.at.x, text.at.y - 0.75 * text.size}, {text.at.x + filmTextWidth(text.text, text.size), text.at.y}};
}

} // namespace moment_pictures

TEST_CASE("Film: the labels of a moment name A, B and C of its advance, and every candidate") {
    for (const Method method : {Method::Classic, Method::Fast}) {
        MeshStepper stepper = moment_pictures::run(method);
        for (std::uint64_t advance = 1; advance <= 20; ++advance) {
            CAPTURE(advance);
            const FilmScene scene = moment_pictures::sceneAt(stepper, advance);
            const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
            const std::vector<std::pair<std::string, Vec2>> expected = {
                {"A", told->a}, {"B", told->b}, {"C", told->ideal}};
            for (const auto &[name, place] : expected) {
                const std::vector<FilmText> labels = moment_pictures::named(scene, name);
                REQUIRE(labels.size() == 1);
                CHECK(*labels.front().place == place);
            }
            const auto count = std::count_if(scene.texts.begin(), scene.texts.end(),
                                             [](const FilmText &text) { return text.place.has_value(); });
            CHECK(static_cast<std::size_t>(count) == 3 + told->candidates.size());
            const double scale = (800.0 - 24.0) / 4.0;                           // pixels per unit of length
            REQUIRE(scene.circles.size() == (told->searchRadius > 0.0 ? 1 : 0)); // a fan needs no search
            for (const FilmCircle &circle : scene.circles) {
                CHECK(circle.radius == doctest::Approx(scale * told->searchRadius));
            }
        }
    }
}

TEST_CASE("Film: labels of a moment do not overlap") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    for (std::uint64_t advance = 1; advance <= 20; ++advance) {
        CAPTURE(advance);
        const FilmScene scene = moment_pictures::sceneAt(stepper, advance);
        std::vector<Box2> boxes;
        for (const FilmText &text : scene.texts) {
            if (text.place) {
                boxes.push_back(moment_pictures::boxOf(text));
            }
        }
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const Box2 &a = boxes[i], &b = boxes[k];
                CHECK_FALSE((a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y));
            }
        }
    }
}

TEST_CASE("Film: the label of a candidate ends with its verdict, unless it was not tested") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    std::size_t verdicts = 0;
    for (std::uint64_t advance = 1; advance <= 30; ++advance) {
        const FilmScene scene = moment_pictures::sceneAt(stepper, advance);
        const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
        const std::vector<CandidateTrace> &candidates = told->candidates;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            const auto label = std::ranges::find_if(scene.texts, [&](const FilmText &text) {
                return text.place && text.text.starts_with(std::to_string(k + 1) + ": ");
            });
            REQUIRE(label != scene.texts.end());
            const Verdict verdict = candidates[k].verdict;
            const std::string word = verdict == Verdict::Withdrawn ? "too near" : verdictText(verdict);
            CHECK(label->text.ends_with(word) == (verdict != Verdict::NotTried));
            verdicts += verdict != Verdict::NotTried ? 1U : 0U;
        }
    }
    CHECK(verdicts > 30);
}

TEST_CASE("Film: a legend stands between the drawing and the caption, on any width") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    stepper.seek(9);
    const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot(moment_pictures::labelled().needed());
    for (const int width : {120, 300, 800}) {
        CAPTURE(width);
        FilmSheet sheet{stepper.mesh().bounds(), width};
        const int without = sheet.height();
        sheet.legend = true;
        CHECK(sheet.height() > without);
        const FilmScene scene = sceneOf(*moment, sheet, moment_pictures::labelled());
        const auto legend = [&](const char *word) {
            const auto found = std::ranges::find_if(scene.texts, [&](const FilmText &t) { return t.text == word; });
            REQUIRE(found != scene.texts.end());
            return *found;
        };
        CHECK(legend("accepted").ink == Ink::Accepted);
        const FilmText last = legend("circle: search around C"), caption = scene.texts.back();
        CHECK(legend("base AB").at.y > sheet.bandTop());
        CHECK(last.at.y < caption.at.y);
        CHECK(last.at.y <= legend("not tested").at.y + 18.0);
        CHECK(caption.at.y < scene.height);
    }
}

TEST_CASE("Film: an SVG and a PDF of a moment keep its labels as text") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    const FilmScene scene = moment_pictures::sceneAt(stepper, 9);
    const std::string svg = svgOf(scene), pdf = pdfOf(scene);
    const Vec2 a = stepper.explanation()->a;
    CHECK(svg.find("data-x=\"" + exactText(a.x) + "\" data-y=\"" + exactText(a.y) + "\">A</text>") !=
          std::string::npos);
    for (const FilmText &text : scene.texts) {
        if (text.place) {
            CHECK(svg.find('>' + text.text + "</text>") != std::string::npos);
            CHECK(pdf.find('(' + text.text + ") Tj") != std::string::npos);
        }
    }
    FilmScene empty;
    empty.width = 100;
    empty.height = 100;
    empty.texts.push_back({{10, 50}, "\xce\xb1 (\\)", Ink::Text, 13.0, {}});
    CHECK(pdfOf(empty).find("/F2 13 Tf (a) Tj\n/F1 13 Tf ( \\(\\\\\\)) Tj") != std::string::npos);
}

TEST_CASE("Film: the objects of a PDF begin where its table says") {
    MeshStepper stepper = moment_pictures::run(Method::Fast);
    const std::string pdf = pdfOf(moment_pictures::sceneAt(stepper, 5));
    const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref\n") + 10));
    REQUIRE(pdf.substr(table, 9) == "xref\n0 7\n");
    for (std::size_t k = 1; k < 7; ++k) {
        const std::size_t offset = std::stoul(pdf.substr(table + 9 + 20 * k, 10));
        CHECK(pdf.substr(offset, 7) == std::to_string(k) + " 0 obj");
    }
    const std::size_t length = std::stoul(pdf.substr(pdf.find("/Length ") + 8));
    CHECK(pdf.find("endstream") == pdf.find("stream\n") + 7 + length);
}

TEST_CASE("Film: a PNG of a moment has the circle of the search, and the last moment says that it is improved") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    FilmScene scene = moment_pictures::sceneAt(stepper, 9);
    REQUIRE(scene.circles.size() == 1);
    FilmCircle &circle = scene.circles.front();
    circle = {{400.0, 300.0}, 50.5, Ink::Rejected, 3.0};
    scene.lines.clear();
    scene.texts.clear();
    const FilmPicture picture = paintScene(scene);
    for (const int x : {350, 450}) {
        CHECK(picture.row(300)[x] == static_cast<std::uint8_t>(Ink::Rejected));
    }
    CHECK(picture.row(300)[400] != static_cast<std::uint8_t>(Ink::Rejected));
    REQUIRE(stepper.finish());
    const FilmScene last = moment_pictures::sceneAt(stepper, stepper.known());
    CHECK(std::none_of(last.texts.begin(), last.texts.end(),
                       [](const FilmText &text) { return text.place.has_value(); }));
    REQUIRE_FALSE(last.texts.empty());
    CHECK(last.texts.front().text.find("the mesh is improved") != std::string::npos);
}

TEST_CASE("Film: a view shows a part of the plane, and its shapes end at the band of the caption") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    stepper.finish();
    stepper.seek(30);
    const FilmLayers layers = moment_pictures::labelled();
    const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot(layers.needed());
    const FilmSheet whole{stepper.mesh().bounds(), 800};
    const Vec2 a = moment->explanation->a;
    const FilmSheet part{boxAround(a, 0.5), 800, true}, elsewhere{boxAround(a + Vec2{3.0, 3.0}, 0.1), 800, true};
    const FilmScene far = sceneOf(*moment, whole, layers, 60), near = sceneOf(*moment, part, layers, 60);
    CHECK(far.paperFrom == whole.bandTop()); // the circle of the search may reach beyond the whole domain, too
    FilmLayers plain;
    CHECK_FALSE(sceneOf(*moment, whole, plain, 60).paperFrom);
    REQUIRE(near.paperFrom);
    CHECK(*near.paperFrom == doctest::Approx(part.bandTop()));
    CHECK(near.elements.size() < far.elements.size());
    CHECK(near.elements.size() > 0);
    CHECK(moment_pictures::named(near, "A").size() == 1);
    CHECK(moment_pictures::named(sceneOf(*moment, elsewhere, layers, 60), "A").empty()); // A is not on the sheet
    CHECK(svgOf(near).find("<rect y=") != std::string::npos);
}

TEST_CASE("Film: within an advance, a scene shows only what its events have told so far") {
    MeshStepper stepper = moment_pictures::run(Method::Classic);
    const FilmLayers layers = moment_pictures::labelled();
    stepper.seek(12);
    std::size_t before = 0, events = 0;
    while (stepper.position() < 13) {
        stepper.step(Granularity::Event, 1);
        const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot(layers.needed());
        const FilmScene scene = sceneOf(*moment, {stepper.mesh().bounds(), 800}, layers, 60);
        const std::size_t labels = static_cast<std::size_t>(std::count_if(
            scene.texts.begin(), scene.texts.end(), [](const FilmText &text) { return text.place.has_value(); }));
        CHECK(labels >= before);
        CHECK(labels >= 2); // A and B
        if (events == 0) {
            CHECK(moment_pictures::named(scene, "C").empty());
            CHECK(scene.circles.empty());
        }
        before = labels;
        ++events;
    }
    CHECK(events >= 5);
    CHECK(before == 3 + stepper.explanation()->candidates.size());
}

} // namespace forefront
