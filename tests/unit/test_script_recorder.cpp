#include "core/drawing/commands/corner_commands.hpp"
#include "core/drawing/commands/guide_commands.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/document/equality.hpp"
#include "core/drawing/document/history.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing_files/script/script_player.hpp"
#include "core/drawing_files/script/script_recorder.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace forefront::recorder_test {

std::string hashOf(const Document &document) {
    const Result<MeshingOutcome> outcome = meshDomain(jobOf(document));
    return outcome ? toHex(meshHash(outcome->mesh)) : outcome.faults().front().code;
}

/// Replays a script; hashes that it names are compared.
Document replayed(const std::string &text) {
    const SourceText source{text, "session", {}, {}};
    const Result<Script> script = Script::read(source);
    REQUIRE_MESSAGE(script.ok(), toString(script.faults().front()));
    ScriptPlayer player;
    for (const ScriptCommand &command : script->commands()) {
        if (editsDocument(command.word)) {
            const Status faults = player.play(command, source);
            REQUIRE_MESSAGE(faults.empty(), toString(faults.front()) << '\n' << text);
        } else if (command.word == ScriptWord::Mesh) {
            CHECK(optionalText(command, "hash", source).value() == hashOf(player.document()));
        }
    }
    return player.document();
}

/// A session of an editor: its history, recorded.
class Session {
  public:
    explicit Session(Document start = {}) : history_(std::move(start)), recorder_(history_.shared()) {}

    /// Applies the result of a command as the editor does, or nothing if it was refused.
    void apply(Result<Document> next) {
        if (next) {
            next = completeCommand(history_.document(), *std::move(next));
        }
        if (next) {
            history_.commit("command", *std::move(next));
            recorder_.record(history_.shared());
        }
    }
    void walk(std::size_t entry) {
        history_.goTo(entry);
        recorder_.record(history_.shared());
    }
    void open(Document document) {
        history_ = History(std::move(document));
        recorder_.load(history_.shared());
    }
    const Document &document() const { return history_.document(); }
    const History &history() const { return history_; }
    ScriptRecorder &recorder() { return recorder_; }
    const std::string &text() const { return recorder_.text(); }

  private:
    History history_;
    ScriptRecorder recorder_;
};

void requireSame(const Document &replay, const Document &recorded, const std::string &text) {
    INFO(text);
    REQUIRE(sameContent(replay, recorded));
    REQUIRE(replay.nextId == recorded.nextId);
}

bool says(const Session &session, std::string_view part) {
    INFO(session.text());
    return session.text().find(part) != std::string::npos;
}

Shape randomShape(edit_test::Random &random) {
    const Vec2 low = random.place(10), size = {random.real(1, 4), random.real(1, 4)};
    switch (random.below(3)) {
    case 0:
        return edit_test::makeShape(ShapeKind::Rectangle, {low, low + size});
    case 1:
        return edit_test::makeShape(ShapeKind::Circle, {low, low + Vec2{size.x, 0}});
    default:
        return edit_test::makeShape(ShapeKind::Polygon, {low, low + Vec2{size.x, 0}, low + size});
    }
}

void constrainAtRandom(Session &session, edit_test::Random &random, std::uint32_t shape) {
    const auto kind =
        static_cast<ConstraintKind>(random.below(static_cast<std::uint32_t>(wordsOf<ConstraintKind>().size())));
    session.apply(addConstraint(session.document(), kind, {{shape, SketchPartKind::Segment, random.below(4)}}));
}

/// Carries out one of the commands that a user has, or opens, or steps back or forward.
void actAtRandom(Session &session, edit_test::Random &random) {
    const Document &document = session.document();
    const std::uint32_t shape = 1 + random.below(std::max(2U, document.nextId) - 1);
    const auto tag = static_cast<std::int32_t>(1 + random.below(3));
    switch (random.below(13)) {
    case 0:
        return session.apply(removeShapes(document, {shape}));
    case 1:
        return session.apply(moveSelection(document, edit_test::selected({shape}), random.place(3)));
    case 2:
        return session.apply(setHandle(document, {shape, random.below(3)}, random.place(8)));
    case 3:
        return session.apply(nameBoundaryPart(document, {{shape}, {}}, "part " + std::to_string(tag)));
    case 4:
        return session.apply(renameBoundaryTag(document, tag, "wall " + std::to_string(random.below(9))));
    case 5:
        return session.apply(setSize(document, random.real(0.5, 2)));
    case 6:
        return session.apply(setPartSize(document, tag, PartSize{.size = random.real(0.2, 1)}));
    case 7:
        return session.apply(setParameters(document, {{"a", std::to_string(1 + random.below(9))}}));
    case 8:
        return constrainAtRandom(session, random, shape);
    case 9:
        return session.apply(addGuide(document, {random.below(2) == 0, random.real(-5, 5)}));
    case 10:
        return session.walk(random.below(static_cast<std::uint32_t>(session.history().size())));
    case 11:
        return session.apply(filletCorners(document, edit_test::selected({shape}), 0.1));
    default:
        return session.apply(addShape(document, randomShape(random)));
    }
}

TEST_CASE("Script recorder: a session is written as the commands of the user") {
    Session session;
    session.apply(addShape(session.document(), edit_test::makeShape(ShapeKind::Rectangle, {{0, 0}, {4, 2}})));
    session.apply(addShape(session.document(), edit_test::makeShape(ShapeKind::Circle, {{2, 1}, {2.5, 1}})));
    session.apply(moveSelection(session.document(), edit_test::selected({2}), {0.25, 0}));
    session.apply(renameBoundaryTag(session.document(), 1, "wall"));
    session.apply(setSize(session.document(), 0.5));
    session.apply(setParameters(session.document(), {{"r", "0.5"}}));
    const Document last = session.document();
    session.walk(4);
    session.walk(6);
    session.recorder().recordExport("plate.msh", "", meshHash(meshDomain(jobOf(last))->mesh));
    for (const char *part :
         {"{\"command\": \"new\"}\n", "{\"command\": \"add\", \"shapes\": [{",
          "{\"command\": \"move\", \"shapes\": [2], \"by\": [0.25, 0",
          "{\"command\": \"name\", \"boundary\": 1, \"name\": \"wall\"}", "{\"command\": \"size\", \"size\": 0.5}",
          "{\"command\": \"parameter\", \"name\": \"r\", \"expression\": \"0.5\"}",
          "{\"command\": \"undo\", \"steps\": 2}\n{\"command\": \"redo\", \"steps\": 2}\n{\"command\": \"mesh\", "
          "\"hash\": \"",
          "{\"command\": \"export\", \"file\": \"plate.msh\"}\n"}) {
        CHECK_MESSAGE(says(session, part), part << " in\n" << session.text());
    }
    CHECK_FALSE(says(session, "\"change\""));
    CHECK(session.recorder().commands() == 11);
    requireSame(replayed(session.text()), last, session.text());
}

TEST_CASE("Script recorder: a mesh is recorded once for each document") {
    Session session(edit_test::documentOf({edit_test::square({0, 0}, 2)}));
    const std::uint64_t hash = meshHash(meshDomain(jobOf(session.document()))->mesh);
    session.recorder().recordMesh(hash);
    session.recorder().recordMesh(hash);
    session.recorder().recordExport("a.msh", "gmsh", hash);
    CHECK(session.recorder().commands() == 3);
    CHECK(says(session, "\"format\": \"gmsh\""));
    session.recorder().recordExport("a.14", "", hash, {"sea", "a \"b\""}, "-5 - x");
    CHECK(says(session, "{\"command\": \"export\", \"file\": \"a.14\", \"open\": [\"sea\", \"a \\\"b\\\"\"], "
                        "\"elevation\": \"-5 - x\"}\n"));
    session.apply(setSize(session.document(), 0.75));
    session.recorder().recordMesh(meshHash(meshDomain(jobOf(session.document()))->mesh));
    CHECK(session.recorder().commands() == 6);
    requireSame(replayed(session.text()), session.document(), session.text());
}

TEST_CASE("Script recorder: random sessions replay to equal documents and meshes") {
    std::size_t meshed = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        edit_test::Random random(seed);
        Session session(seed % 3 == 0 ? edit_test::documentOf({edit_test::square({0, 0}, 5)}) : Document());
        for (int k = 0; k < 25; ++k) {
            actAtRandom(session, random);
        }
        if (seed % 4 == 0) {
            session.open(edit_test::documentOf({edit_test::square({1, 1}, 3)}));
            actAtRandom(session, random);
        }
        const Document replay = replayed(session.text());
        requireSame(replay, session.document(), session.text());
        const std::string hash = hashOf(session.document());
        CHECK(hashOf(replay) == hash);
        meshed += hash.size() == 16 ? 1U : 0U;
    }
    CHECK(meshed >= 3);
}

} // namespace forefront::recorder_test
