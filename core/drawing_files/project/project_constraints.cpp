#include "core/drawing_files/project/project_constraints.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/orient.hpp"
#include "core/files/json/json.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace forefront {

void writeConstraints(const Document &document, JsonText &out) {
    if (document.constraints.empty()) {
        return;
    }
    out << ",\n  \"constraints\": [\n    ";
    out.list(document.constraints, ",\n    ", [&](const auto &pointer) {
        const SketchConstraint &constraint = *pointer;
        out << "{\"id\": " << constraint.id << ", \"kind\": \"" << wordOf(constraint.kind)
            << "\", \"name\": " << jsonString(constraint.name) << ", \"of\": [";
        out.list(constraint.parts, ", ", [&](const SketchPart &part) { out << '"' << toString(part) << '"'; });
        out << ']';
        if (isDimension(constraint.kind)) {
            out << ", \"value\": ";
            out.number(constraint.value);
        }
        if (constraint.side != 1) {
            out << ", \"side\": " << constraint.side;
        }
        if (constraint.otherSide != 1) {
            out << ", \"otherSide\": " << constraint.otherSide;
        }
        if (constraint.turn != 0) {
            out << ", \"turn\": " << constraint.turn;
        }
        if (constraint.label) {
            out << ", \"label\": ";
            out.point(*constraint.label);
        }
        out << '}';
    });
    out << "\n  ]";
}

namespace {

class ConstraintReader {
  public:
    ConstraintReader(const std::map<std::uint32_t, std::uint32_t> &renumbered, Document &document, JsonCheck &check)
        : renumbered_(renumbered), document_(document), check_(check) {}

    void read(const JsonValue &item) {
        SketchConstraint constraint;
        if (const auto id = check_.member(item, "id", "the constraint")) {
            constraint.id = static_cast<std::uint32_t>(check_.integer(*id, 1, kMaxId, "the id of a constraint"));
            if (!ids_.emplace(constraint.id).second) {
                check_.fault(*id, "duplicate-id", "another constraint has the id " + std::to_string(constraint.id));
            }
        }
        if (const auto kind = check_.member(item, "kind", "the constraint")) {
            constraint.kind = static_cast<ConstraintKind>(
                check_.choice(*kind, wordsOf<ConstraintKind>(), "the kind of a constraint"));
        }
        if (const auto name = item.find("name")) {
            constraint.name = check_.string(*name, "the name of a constraint");
        }
        if (constraint.name.empty()) {
            constraint.name = kindName(constraint.kind) + ' ' + std::to_string(constraint.id);
        }
        readNumbers(item, constraint);
        const std::size_t before = check_.faults().size();
        readParts(item, constraint);
        check_.noteUnknown(item, {"id", "kind", "name", "of", "value", "side", "otherSide", "turn", "label"});
        if (check_.faults().size() == before) {
            const std::string fault = constraintFault(document_, constraint);
            if (!fault.empty()) {
                check_.fault(item, "bad-constraint", "constraint " + inQuotes(constraint.name) + ": " + fault);
            } else if (isSlantedDistance(document_, constraint)) { // its lines may have been turned since it was added
                check_.warn(item, "constraint-slanted",
                            "constraint " + inQuotes(constraint.name) +
                                ": its lines are not parallel; it measures from " + "the start of one of them");
            }
        }
        document_.constraints.push_back(std::make_shared<const SketchConstraint>(std::move(constraint)));
    }

  private:
    static constexpr std::int64_t kMaxId = std::numeric_limits<std::uint32_t>::max() / 4; // leaves room for new ones

    void readNumbers(const JsonValue &item, SketchConstraint &constraint) {
        if (isDimension(constraint.kind)) {
            if (const auto value = check_.member(item, "value", "the dimension")) {
                constraint.value = check_.positive(*value, "the value of a dimension");
            }
        }
        if (const auto label = item.find("label"); label && isDimension(constraint.kind)) {
            constraint.label = check_.point(*label, "the label of a dimension");
        }
        constraint.side = sign(item, "side");
        constraint.otherSide = sign(item, "otherSide");
        if (const auto turn = item.find("turn")) {
            constraint.turn = static_cast<int>(check_.integer(*turn, -90, 180, "the turn of a constraint"));
            if (constraint.turn % 90 != 0) {
                check_.fault(*turn, "bad-number", "the turn of a constraint must be -90, 0, 90 or 180");
            }
        }
    }

    int sign(const JsonValue &item, const char *member) {
        const auto given = item.find(member);
        const std::int64_t value = given ? check_.integer(*given, -1, 1, inQuotes(member)) : 1;
        if (value == 0) {
            check_.fault(*given, "bad-number", inQuotes(member) + " must be 1 or -1");
        }
        return value < 0 ? -1 : 1;
    }

    void readParts(const JsonValue &item, SketchConstraint &constraint) {
        const auto list = check_.member(item, "of", "the constraint");
        if (!list || !check_.expect(*list, JsonKind::Array, "the parts of a constraint")) {
            return;
        }
        constexpr std::size_t kMaxParts = 4;
        for (const JsonValue entry : *list) {
            const std::string text = check_.string(entry, "a part of a constraint");
            std::optional<SketchPart> part = parseSketchPart(text);
            if (!part || constraint.parts.size() == kMaxParts) {
                check_.fault(entry, "bad-constraint",
                             part ? "a constraint has at most 4 parts"
                                  : "invalid part " + inQuotes(text) +
                                        "; expected one such as \"shape/1/node/0\" or \"shape/1/segment/0\"");
                return;
            }
            if (const auto found = renumbered_.find(part->shape); found != renumbered_.end()) {
                part->shape = found->second;
            }
            constraint.parts.push_back(*part);
        }
    }

    const std::map<std::uint32_t, std::uint32_t> &renumbered_;
    Document &document_;
    JsonCheck &check_;
    std::set<std::uint32_t> ids_;
};

} // namespace

void readConstraints(const JsonValue &root, const std::map<std::uint32_t, std::uint32_t> &renumbered,
                     Document &document, JsonCheck &check) {
    const auto list = root.find("constraints");
    if (!list || !check.expect(*list, JsonKind::Array, "\"constraints\"")) {
        return;
    }
    if (!check.faults().empty()) { // of shapes, which the parts of constraints may need
        return;
    }
    ConstraintReader reader(renumbered, document, check);
    for (const JsonValue item : *list) {
        if (check.full()) {
            return;
        }
        if (check.expect(item, JsonKind::Object, "a constraint")) {
            reader.read(item);
        }
    }
    std::sort(document.constraints.begin(), document.constraints.end(),
              [](const auto &a, const auto &b) { return a->id < b->id; });
    if (!document.constraints.empty()) {
        document.nextId = std::max(document.nextId, document.constraints.back()->id + 1);
    }
}

} // namespace forefront
