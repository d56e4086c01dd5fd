#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/commands/transform.hpp"
#include "core/drawing/constraints/carry_constraints.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "tests/unit/constraint_samples.hpp"
#include "tests/unit/edit_support.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace forefront::constraint_test {

using namespace edit_test;
using Kind = ConstraintKind;

TEST_CASE("Constraints: random commands leave constraints that hold, or are refused") {
    std::size_t applied = 0, refused = 0, lost = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Document document = everyShape();
        const auto anyPart = [&] {
            const std::vector<SketchPart> parts = partsOf(document);
            return parts[random.below(static_cast<std::uint32_t>(parts.size()))];
        };
        for (int step = 0; step < 25; ++step) {
            CAPTURE(step);
            Result<Document> next = document;
            switch (random.below(11)) {
            case 0:
            case 1:
            case 2:
                next = addConstraint(document, static_cast<Kind>(random.below(20)), {anyPart(), anyPart()});
                break;
            case 3: {
                const Shape &shape = *document.shapes[random.below(static_cast<std::uint32_t>(document.shapes.size()))];
                const auto handle = random.below(static_cast<std::uint32_t>(handleCount(shape)));
                next = setHandle(document, {shape.id, handle}, handlesOf(shape)[handle] + random.place(1.0));
                break;
            }
            case 4:
                if (!document.constraints.empty()) {
                    const auto &one =
                        *document.constraints[random.below(static_cast<std::uint32_t>(document.constraints.size()))];
                    next = setDimension(document, one.id, one.value * random.real(0.8, 1.3));
                }
                break;
            case 5: {
                const Shape &shape = *document.shapes[0];
                if (isPath(shape)) {
                    next = insertNode(document, {shape.id, 0}, midpoint(shape.nodes[0], shape.nodes[1]));
                }
                break;
            }
            case 6: {
                Selection gone;
                const Shape &shape = *document.shapes[random.below(static_cast<std::uint32_t>(document.shapes.size()))];
                gone.nodes = {{shape.id, random.below(static_cast<std::uint32_t>(handleCount(shape)))}};
                if (document.shapes.size() > 6) {
                    next = deleteSelection(document, gone);
                }
                break;
            }
            case 7:
                next = convertToPath(document, document.shapes[random.below(5)]->id);
                break;
            case 8: {
                const std::uint32_t id = document.shapes[random.below(5)]->id;
                next =
                    transformSelection(document, selected({id}),
                                       random.below(2) == 0 ? PlaneMap::rotation(random.real(-90, 90), random.place(9))
                                                            : PlaneMap::reflection(90.0, random.place(9)));
                break;
            }
            case 9: {
                const std::uint32_t id = document.shapes[random.below(5)]->id;
                if (document.shapes.size() < 12) {
                    next = duplicateSelection(document, selected({id, document.shapes[5]->id}), {3, 4}, nullptr);
                }
                break;
            }
            default:
                next = toggleClosed(document, document.shapes[0]->id);
            }
            next = next ? settleCommand(document, *next) : next;
            next ? ++applied : ++refused;
            if (next) {
                lost += lostConstraints(document, *next).size();
                document = *std::move(next);
                checkAllHold(document);
            }
        }
        const std::string text = projectText(document);
        const Result<Document> read = parseProject(text, "a.json");
        REQUIRE_MESSAGE(read.ok(), messageOf(read));
        CHECK(projectText(*read) == text);
    }
    INFO(applied, " applied, ", refused, " refused, ", lost, " constraints lost");
    CHECK(applied > 1500);
    CHECK(refused > 300);
    CHECK(lost > 5);
}

} // namespace forefront::constraint_test
