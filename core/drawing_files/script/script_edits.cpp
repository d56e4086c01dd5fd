#include "core/drawing_files/script/script_edits.hpp"

#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/commands/settle_command.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/script/project_parts.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr std::int64_t kMaxShapeId = std::numeric_limits<std::uint32_t>::max() - 1;

/// A number, with the formula that it was given by.
struct ScriptNumber {
    double value = 0.0;
    std::string formula; ///< empty: a plain number
};

/// Carries out one command. What is wrong with its members is collected in `check_`.
class ScriptEdit {
  public:
    ScriptEdit(const Document &document, const ScriptCommand &command, const SourceText &source)
        : document_(document), command_(command), source_(source), check_(source) {}

    Result<Document> run() {
        Result<Document> next = dispatch();
        if (!check_.faults().empty()) {
            return check_.faults();
        }
        return next;
    }

  private:
    Result<Document> dispatch() {
        switch (command_.word) {
        case ScriptWord::New:
            return begin();
        case ScriptWord::Add:
            return completed(add());
        case ScriptWord::Move:
            return completed(move());
        case ScriptWord::Constrain:
            return completed(constrain());
        case ScriptWord::Name:
            return completed(name());
        case ScriptWord::Size:
            return completed(size());
        case ScriptWord::Parameter:
            return completed(parameter());
        case ScriptWord::Change:
            return change();
        default:
            return error("bad-value", "the command " + std::string(wordOf(command_.word)) + " changes no document");
        }
    }

    std::optional<JsonValue> find(std::string_view member) const { return command_.value.find(member); }
    std::optional<JsonValue> required(std::string_view member) {
        return check_.member(command_.value, member, "the command " + std::string(wordOf(command_.word)));
    }
    Result<Document> completed(Result<Document> next) const {
        return next && check_.faults().empty() ? completeCommand(document_, *std::move(next)) : next;
    }
    std::string_view text(const JsonValue &value) const { return textOf(source_.text, value); }

    Result<Document> begin() {
        const auto project = find("project");
        if (!project) {
            return Document();
        }
        if (!check_.expect(*project, JsonKind::Object, "\"project\"")) {
            return document_;
        }
        return readProjectValue(*project, source_);
    }

    /// Adds the shapes of an array to the parts, in place of those with the same ids if `replaces`.
    void take(const JsonValue &list, std::string_view member, bool replaces, ProjectParts &parts) {
        if (!check_.expect(list, JsonKind::Array, inQuotes(member))) {
            return;
        }
        for (const JsonValue item : list) {
            if (!check_.expect(item, JsonKind::Object, "a shape")) {
                continue;
            }
            const auto given = item.find("id");
            const auto id = static_cast<std::uint32_t>(
                given ? check_.integer(*given, 1, kMaxShapeId, "the id of a shape") : std::int64_t{0});
            const auto same = std::find_if(parts.shapes.begin(), parts.shapes.end(),
                                           [&](const auto &shape) { return id != 0 && shape.id == id; });
            if (same == parts.shapes.end()) {
                parts.shapes.push_back({id, std::string(text(item)), item.offset()});
            } else if (replaces) {
                *same = {id, std::string(text(item)), item.offset()};
            } else {
                check_.fault(*given, "duplicate-id", "another shape has the id " + std::to_string(id),
                             "leave \"id\" out for the next free one");
            }
        }
    }

    Result<Document> add() {
        ProjectParts parts = ProjectParts::of(document_);
        if (const auto shapes = required("shapes")) {
            take(*shapes, "shapes", false, parts);
        }
        return check_.faults().empty() ? parts.read(source_) : Result<Document>(document_);
    }

    std::set<std::uint32_t> shapeIds(const JsonValue &list, std::string_view member) {
        std::set<std::uint32_t> ids;
        if (check_.expect(list, JsonKind::Array, inQuotes(member))) {
            for (const JsonValue item : list) {
                const auto id = static_cast<std::uint32_t>(check_.integer(item, 1, kMaxShapeId, "the id of a shape"));
                if (findShape(document_, id) == nullptr) {
                    check_.fault(item, "no-such-shape", "shape " + std::to_string(id) + " not found");
                }
                ids.insert(id);
            }
        }
        return ids;
    }

    /// Reads references to parts of the drawing such as "shape/1/node/0".
    std::vector<SketchPart> parts(const JsonValue &list, std::string_view member) {
        std::vector<SketchPart> parts;
        if (check_.expect(list, JsonKind::Array, inQuotes(member))) {
            for (const JsonValue item : list) {
                const std::string word = check_.string(item, "a part");
                if (const auto part = parseSketchPart(word)) {
                    parts.push_back(*part);
                } else if (item.is(JsonKind::String)) {
                    check_.fault(item, "bad-value",
                                 "unknown part " + inQuotes(word) +
                                     "; expected such as shape/1/node/0 or "
                                     "shape/1/segment/0");
                }
            }
        }
        return parts;
    }

    Result<Document> move() {
        Selection selection;
        const auto shapes = find("shapes"), nodes = find("nodes");
        if (!shapes && !nodes) {
            required("shapes");
        }
        if (shapes) {
            selection.shapes = shapeIds(*shapes, "shapes");
        }
        if (nodes) {
            for (const SketchPart &part : parts(*nodes, "nodes")) {
                if (part.kind != SketchPartKind::Node) {
                    check_.fault(*nodes, "bad-value", "expected nodes such as shape/1/node/0, got " + toString(part));
                }
                selection.nodes.insert({part.shape, part.index});
            }
        }
        const auto by = required("by"), alone = find("alone");
        const Vec2 shift = by ? check_.point(*by, "\"by\"") : Vec2();
        const bool detaches = alone && check_.flag(*alone, "\"alone\"");
        if (!check_.faults().empty()) {
            return document_;
        }
        const Result<Document> next = moveSelection(document_, selection, shift);
        return next && !detaches ? carryJoints(document_, *next) : next;
    }

    /// Reads a number, or an expression of parameters.
    ScriptNumber number(const JsonValue &value, std::string_view what) {
        if (!value.is(JsonKind::String)) {
            return {check_.number(value, what), {}};
        }
        const std::string formula = value.string();
        const Result<double> result = evaluateFormula(document_, formula);
        if (!result) {
            check_.fault(value, result.faults().front().code,
                         std::string(what) + ": " + result.faults().front().message);
            return {};
        }
        return {*result, formula};
    }

    static Result<Document> withFormula(Result<Document> next, const NumberAddress &address,
                                        const ScriptNumber &number) {
        return next && !number.formula.empty() ? setFormula(*std::move(next), address, number.formula) : next;
    }

    Result<Document> constrain() {
        const auto kind = required("kind"), list = required("parts"), value = find("value");
        if (!kind || !list) {
            return document_;
        }
        const auto chosen = static_cast<ConstraintKind>(check_.choice(*kind, wordsOf<ConstraintKind>(), "the kind"));
        const std::vector<SketchPart> used = parts(*list, "parts");
        const ScriptNumber given = value ? number(*value, "\"value\"") : ScriptNumber();
        if (value && !isDimension(chosen) && check_.faults().empty()) {
            check_.fault(*value, "bad-value",
                         "a constraint of the kind " + std::string(wordOf(chosen)) + " has no value");
        }
        if (!check_.faults().empty()) {
            return document_;
        }
        Result<SketchConstraint> made = makeConstraint(document_, chosen, used);
        if (!made) {
            return made.faults();
        }
        made->value = value ? given.value : made->value;
        const std::uint32_t id = made->id;
        return withFormula(addConstraint(document_, *std::move(made)),
                           {NumberOwner::ofConstraint(id), Quantity::Value, 0}, given);
    }

    Result<Document> name() {
        const auto given = required("name");
        const std::string name = given ? check_.string(*given, "\"name\"") : std::string();
        const auto boundary = find("boundary"), shape = find("shape"), segments = find("segments"),
                   marker = find("regionMarker");
        const int count = (boundary ? 1 : 0) + (shape ? 1 : 0) + (segments ? 1 : 0) + (marker ? 1 : 0);
        if (count != 1) {
            check_.fault(command_.value, "bad-value",
                         "expected one of the members boundary, shape, segments and regionMarker, found " +
                             std::to_string(count));
            return document_;
        }
        if (boundary) {
            const std::int32_t tag = check_.tag(*boundary);
            return check_.faults().empty() ? renameBoundaryTag(document_, tag, name) : Result<Document>(document_);
        }
        if (marker) {
            const auto at = static_cast<std::size_t>(check_.integer(*marker, 0, kMaxShapeId, "\"regionMarker\""));
            return check_.faults().empty() ? nameRegionOf(document_, at, name) : Result<Document>(document_);
        }
        BoundaryPart part;
        if (shape) {
            part.shapes.insert(static_cast<std::uint32_t>(check_.integer(*shape, 1, kMaxShapeId, "\"shape\"")));
        } else {
            for (const SketchPart &segment : parts(*segments, "segments")) {
                part.segments.insert({segment.shape, segment.index});
                if (segment.kind != SketchPartKind::Segment) {
                    check_.fault(*segments, "bad-value",
                                 "expected segments such as shape/1/segment/0, got " + toString(segment));
                }
            }
        }
        return check_.faults().empty() ? nameBoundaryPart(document_, part, name) : Result<Document>(document_);
    }

    Result<Document> size() {
        const auto size = find("size"), expression = find("expression"), boundary = find("boundary"),
                   growth = find("growth");
        if ((size ? 1 : 0) + (expression ? 1 : 0) != 1 || (expression && boundary) || (growth && !boundary)) {
            check_.fault(command_.value, "bad-value",
                         "expected size, size with boundary (and growth), or expression alone");
            return document_;
        }
        if (expression) {
            const std::string formula = check_.string(*expression, "\"expression\"");
            return check_.faults().empty() ? Result<Document>(setExpression(document_, formula)) : document_;
        }
        const bool removes = size->is(JsonKind::Null);
        const ScriptNumber given = removes ? ScriptNumber() : number(*size, "\"size\"");
        if (!boundary) {
            return !check_.faults().empty()
                       ? Result<Document>(document_)
                       : withFormula(setSize(document_, removes ? std::nullopt : std::optional(given.value)),
                                     {NumberOwner::ofSpacing(), Quantity::Size, 0}, given);
        }
        const std::int32_t tag = check_.tag(*boundary);
        PartSize part;
        part.size = given.value;
        part.growth = growth ? check_.notNegative(*growth, "\"growth\"") : part.growth;
        return !check_.faults().empty()
                   ? Result<Document>(document_)
                   : withFormula(setPartSize(document_, tag, removes ? std::nullopt : std::optional(part)),
                                 {NumberOwner::ofPart(tag), Quantity::Size, 0}, given);
    }

    Result<Document> parameter() {
        const auto given = required("name"), expression = required("expression");
        if (!given || !expression) {
            return document_;
        }
        const std::string name = check_.string(*given, "\"name\"");
        std::vector<Parameter> parameters = document_.parameters;
        const std::size_t at = parameterIndex(parameters, name);
        if (expression->is(JsonKind::Null)) {
            return removeParameter(document_, at);
        }
        const std::string text = expression->is(JsonKind::Number) ? std::string(expression->numeral())
                                                                  : check_.string(*expression, "\"expression\"");
        if (at == parameters.size()) {
            parameters.push_back({name, text});
        } else {
            parameters[at].expression = text;
        }
        return check_.faults().empty() ? setParameters(document_, std::move(parameters)) : Result<Document>(document_);
    }

    /// Replaces parts of the document as they are, as the recorder does where no other command says the same.
    Result<Document> change() {
        ProjectParts parts = ProjectParts::of(document_);
        if (const auto removed = find("remove")) {
            const std::set<std::uint32_t> gone = shapeIds(*removed, "remove");
            std::erase_if(parts.shapes, [&](const auto &shape) { return gone.contains(shape.id); });
        }
        if (const auto members = find("members"); members && check_.expect(*members, JsonKind::Object, "\"members\"")) {
            for (auto member = members->begin(); member != members->end(); ++member) {
                setMember(member.key(), *member, member.keyValue(), parts);
            }
        }
        if (const auto replaced = find("replace")) {
            take(*replaced, "replace", true, parts);
        }
        return check_.faults().empty() ? parts.read(source_) : Result<Document>(document_);
    }

    void setMember(const std::string &name, const JsonValue &value, const JsonValue &key, ProjectParts &parts) {
        if (name == "shapes") {
            parts.shapes.clear();
            take(value, name, false, parts);
        } else if (value.is(JsonKind::Null) && parts.member(name).empty()) {
            check_.fault(key, "unknown-member", "the project has no member " + inQuotes(name) + " to remove");
        } else {
            parts.set({name, value.is(JsonKind::Null) ? std::string() : std::string(text(value)), value.offset()});
        }
    }

    const Document &document_;
    const ScriptCommand &command_;
    const SourceText &source_;
    JsonCheck check_;
};

} // namespace

Result<Document> editedDocument(const Document &document, const ScriptCommand &command, const SourceText &source) {
    return ScriptEdit(document, command, source).run();
}

} // namespace forefront
