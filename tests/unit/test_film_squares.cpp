#include "core/engine/domain/add_loop.hpp"
#include "core/engine/session/mesh_stepper.hpp"
#include "core/teaching/film/film_picture.hpp"
#include "core/teaching/film/film_scene.hpp"
#include "core/teaching/film/pdf_writer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace forefront {

namespace square_pictures {

MeshStepper run() {
    MeshingJob job;
    addLoop(job.domain, {{0, 0}, {5, 0}, {4.5, 4}, {0, 4}});
    addLoop(job.domain, {{1.2, 1}, {2.5, 1.3}, {2, 2.2}, {1, 2}}, 2);
    job.spacing.size = 0.5;
    job.options.elements = Elements::Quads;
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job));
    REQUIRE(stepper);
    stepper->stepImprovement();
    REQUIRE(stepper->finish());
    return *std::move(stepper);
}

FilmLayers all() {
    FilmLayers layers;
    layers.shown.fill(true);
    return layers;
}

FilmScene sceneHere(MeshStepper &stepper) {
    const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot(all().needed());
    return sceneOf(*moment, {stepper.mesh().bounds(), 800}, all(), stepper.known());
}

std::string captionOf(const FilmScene &scene) {
    std::string text;
    for (const FilmText &each : scene.texts) {
        text += each.place ? "" : (text.empty() ? "" : " ") + each.text;
    }
    return text;
}

std::size_t linesOf(const FilmScene &scene, Ink ink, bool dots) {
    return static_cast<std::size_t>(std::ranges::count_if(
        scene.lines, [&](const FilmLine &line) { return line.ink == ink && (line.a == line.b) == dots; }));
}

} // namespace square_pictures

TEST_CASE("Film: squares are drawn whole once both halves are made, and halves as triangles") {
    MeshStepper stepper = square_pictures::run();
    std::size_t halves = 0, wholes = 0;
    for (std::uint64_t advance = 0; advance <= stepper.known(); ++advance) {
        CAPTURE(advance);
        stepper.seek(advance);
        const FilmScene scene = square_pictures::sceneHere(stepper);
        const Mesh mesh = stepper.mesh();
        const MeshView view(mesh);
        REQUIRE(scene.elements.size() == view.elementCount());
        std::size_t sides = 0;
        for (std::size_t e = 0; e < view.elementCount(); ++e) {
            CHECK(scene.elements[e].count == view.cornersOf(e).size());
            sides += scene.elements[e].count;
            (scene.elements[e].count == 4 ? wholes : halves) += 1;
        }
        CHECK(square_pictures::linesOf(scene, Ink::Edge, false) == sides); // and no diagonal
        const std::string svg = svgOf(scene), pdf = pdfOf(scene);
        CHECK(static_cast<std::size_t>(std::ranges::count(svg, 'Z')) == scene.elements.size());
        const bool isFilled = pdf.find("l f\n") != std::string::npos;
        CHECK(isFilled == !scene.elements.empty());
    }
    CHECK(halves > 0);
    CHECK(wholes > halves);
}

TEST_CASE("Film: a picture is filled inside quadrilaterals, also beyond a reflex corner") {
    FilmScene scene;
    scene.width = scene.height = 100;
    FilmElement dart;
    for (const Vec2 place : {Vec2{10, 10}, Vec2{50, 40}, Vec2{90, 10}, Vec2{50, 90}}) {
        dart.add(place);
    }
    scene.elements.push_back(dart);
    const FilmPicture picture = paintScene(scene);
    const auto inkAt = [&](int x, int y) { return static_cast<Ink>(picture.row(y)[x]); };
    CHECK(inkAt(50, 60) == Ink::Face);
    CHECK(inkAt(20, 20) == Ink::Face);
    CHECK(inkAt(80, 20) == Ink::Face);
    CHECK(inkAt(50, 30) == Ink::Paper); // in the notch
    CHECK(inkAt(20, 60) == Ink::Paper);
}

TEST_CASE("Film: the front of squares shows the colours of its nodes, all of them or none") {
    MeshStepper stepper = square_pictures::run();
    FilmLayers layers;
    layers.shown.fill(false);
    for (const std::uint64_t advance : {std::uint64_t{0}, std::uint64_t{7}, stepper.known() / 2}) {
        stepper.seek(advance);
        layers.shown[static_cast<std::size_t>(FilmLayer::Colours)] = true;
        const FilmSheet sheet{stepper.mesh().bounds(), 1600};
        const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot(layers.needed());
        REQUIRE(moment->front);
        const FilmScene scene = sceneOf(*moment, sheet, layers);
        std::size_t pale = 0;
        for (const FrontSegmentView &segment : *moment->front) {
            REQUIRE(segment.colour >= 0);
            pale += segment.colour == 0 ? 1 : 0;
        }
        CHECK(pale > 0);
        CHECK(square_pictures::linesOf(scene, Ink::Front, true) == moment->front->size());
        CHECK(square_pictures::linesOf(scene, Ink::Paper, true) == pale);
        layers.shown[static_cast<std::size_t>(FilmLayer::Colours)] = false;
        CHECK(sceneOf(*moment, sheet, layers).lines.empty());
    }
}

TEST_CASE("Film: labels tell what squares do and why they are refused, and captions are those of the editor") {
    MeshStepper stepper = square_pictures::run();
    std::size_t rows = 0, openings = 0, refused = 0;
    for (std::uint64_t advance = 1; advance <= stepper.known(); ++advance) {
        CAPTURE(advance);
        stepper.seek(advance);
        const FilmScene scene = square_pictures::sceneHere(stepper);
        const std::shared_ptr<const AdvanceExplanation> told = stepper.explanation();
        const std::string words = caption(*told, told->events.size());
        CHECK(square_pictures::captionOf(scene).find(words.substr(0, 60)) != std::string::npos);
        for (std::size_t k = 0; k < told->candidates.size(); ++k) {
            const CandidateTrace &candidate = told->candidates[k];
            if (candidate.square == SquareKind::None) {
                continue;
            }
            std::string label = std::to_string(k + 1) + ": " + squareText(candidate.square);
            if (candidate.verdict != Verdict::Accepted && candidate.verdict != Verdict::NotTried) {
                label += std::string(", ") + verdictText(candidate.verdict);
                ++refused;
            }
            CHECK(std::ranges::count(scene.texts, label, &FilmText::text) == 1);
            rows += candidate.square == SquareKind::Row ? 1 : 0;
            openings += candidate.square == SquareKind::Opening ? 1 : 0;
        }
        CHECK(scene.circles.size() == (told->searchRadius > 0.0 ? 1 : 0));
    }
    CHECK(rows > 0);
    CHECK(openings > 0);
    CHECK(refused > 0);
}

TEST_CASE("Film: steps of the clean-up are shown with their captions and what they change") {
    MeshStepper stepper = square_pictures::run();
    const std::size_t steps = stepper.snapshot()->improveSteps;
    REQUIRE(steps > 1);
    std::size_t changed = 0;
    for (std::size_t step = 1; step <= steps; ++step) {
        CAPTURE(step);
        stepper.seek(stepper.known());
        stepper.step(Granularity::Event, static_cast<std::int64_t>(step));
        const std::shared_ptr<const SessionSnapshot> moment = stepper.snapshot();
        REQUIRE(moment->improvement);
        const FilmScene scene = square_pictures::sceneHere(stepper);
        const std::string words = caption(*moment->improvement, steps);
        CHECK(words.starts_with("Clean-up " + std::to_string(step) + " of "));
        CHECK(square_pictures::captionOf(scene).starts_with(words.substr(0, 60)));
        const ImproveStep &change = *moment->improvement;
        CHECK(square_pictures::linesOf(scene, Ink::Rejected, false) == change.removedEdges.size());
        changed += change.removedEdges.size() + change.moves.size();
    }
    CHECK(changed > 0);
}

} // namespace forefront
