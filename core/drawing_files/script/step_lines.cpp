#include "core/drawing_files/script/step_lines.hpp"

#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/script/project_parts.hpp"
#include "core/files/json/json.hpp"
#include "core/files/json/json_writer.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace forefront {

namespace {

/// Returns a JSON text in one line.
std::string inOneLine(std::string_view text) {
    std::string line;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\n') {
            line += text[at];
            continue;
        }
        at = std::min(text.find_first_not_of(" \n", at), text.size()) - 1;
    }
    return line;
}

std::string numberJson(double value) {
    JsonWriter json(JsonWriter::Layout::OneLine);
    json.value(value);
    std::string text = json.text();
    text.pop_back(); // its line break
    return text;
}

std::string pointJson(Vec2 p) {
    return "[" + numberJson(p.x) + ", " + numberJson(p.y) + "]";
}

template <class Items, class Text>
std::string listJson(const Items &items, Text textOfItem) {
    std::string list;
    for (const auto &item : items) {
        list += (list.empty() ? "" : ", ") + textOfItem(item);
    }
    return "[" + list + "]";
}

std::string commandLine(const char *word, const std::string &members) {
    return std::string("{\"command\": \"") + word + '"' + (members.empty() ? "" : ", " + members) + "}";
}

/// The difference of two documents.
class DocumentDifference {
  public:
    DocumentDifference(const Document &before, const Document &after)
        : before_(before), after_(after), from_(ProjectParts::of(before)), to_(ProjectParts::of(after)) {
        findShapes();
        for (const ProjectParts::MemberText &member : to_.members) {
            if (member.name != "nextId" && from_.member(member.name) != member.text) {
                members_.emplace_back(member.name, inOneLine(member.text));
            }
        }
        for (const ProjectParts::MemberText &member : from_.members) {
            if (to_.member(member.name).empty()) {
                members_.emplace_back(member.name, "null");
            }
        }
    }

    std::vector<std::string> lines() {
        addParameter();
        addConstraint();
        addSize();
        addName();
        if (members_.empty()) {
            addShapes();
            addMove();
        }
        addChange();
        return std::move(lines_);
    }

  private:
    void findShapes() {
        std::map<std::uint32_t, std::shared_ptr<const Shape>> old;
        for (const auto &shape : before_.shapes) {
            old.emplace(shape->id, shape);
        }
        for (std::size_t k = 0; k < after_.shapes.size(); ++k) {
            const auto found = old.find(after_.shapes[k]->id);
            if (found == old.end()) {
                added_.push_back(k);
                continue;
            }
            if (found->second != after_.shapes[k] && *found->second != *after_.shapes[k]) {
                changed_.emplace_back(found->second, k);
            }
            old.erase(found);
        }
        for (const auto &[id, shape] : old) {
            removed_.push_back(id);
        }
    }

    void add(const char *word, const std::string &members) { lines_.push_back(commandLine(word, members)); }

    void addParameter() {
        std::map<std::string, std::string> old, now;
        for (const Parameter &parameter : before_.parameters) {
            old.emplace(parameter.name, parameter.expression);
        }
        for (const Parameter &parameter : after_.parameters) {
            now.emplace(parameter.name, parameter.expression);
        }
        for (const auto &[name, expression] : now) {
            if (const auto found = old.find(name); found == old.end() || found->second != expression) {
                add("parameter", "\"name\": " + jsonString(name) + ", \"expression\": " + jsonString(expression));
                return;
            }
        }
        for (const auto &[name, expression] : old) {
            if (!now.contains(name)) {
                add("parameter", "\"name\": " + jsonString(name) + ", \"expression\": null");
                return;
            }
        }
    }

    void addConstraint() {
        if (after_.constraints.size() != before_.constraints.size() + 1) {
            return;
        }
        const SketchConstraint &made = *after_.constraints.back();
        std::string members = "\"kind\": \"" + std::string(wordOf(made.kind)) + "\", \"parts\": " +
                              listJson(made.parts, [](const SketchPart &part) { return jsonString(toString(part)); });
        if (isDimension(made.kind)) {
            const auto formula = after_.formulas.find({NumberOwner::ofConstraint(made.id), Quantity::Value, 0});
            members += ", \"value\": " +
                       (formula != after_.formulas.end() ? jsonString(formula->second) : numberJson(made.value));
        }
        add("constrain", members);
    }

    void addSize() {
        if (before_.spacing.expression != after_.spacing.expression && after_.spacing.expression) {
            add("size", "\"expression\": " + jsonString(*after_.spacing.expression));
        }
        const NumberAddress address{NumberOwner::ofSpacing(), Quantity::Size, 0};
        const auto formula = after_.formulas.find(address);
        if (before_.spacing.size != after_.spacing.size ||
            (formula != after_.formulas.end() && !before_.formulas.contains(address))) {
            add("size", "\"size\": " + (formula != after_.formulas.end() ? jsonString(formula->second)
                                        : after_.spacing.size            ? numberJson(*after_.spacing.size)
                                                                         : std::string("null")));
        }
    }

    void addName() {
        for (const auto &[tag, name] : after_.boundaryNames) {
            const auto found = before_.boundaryNames.find(tag);
            if (found != before_.boundaryNames.end() && found->second == name) {
                continue;
            }
            for (const auto &[shape, position] : changed_) {
                add("name", "\"shape\": " + std::to_string(shape->id) + ", \"name\": " + jsonString(name));
            }
            add("name", "\"boundary\": " + std::to_string(tag) + ", \"name\": " + jsonString(name));
            return;
        }
    }

    std::string shapeTexts(const std::vector<std::size_t> &positions) const {
        return listJson(positions, [&](std::size_t k) { return inOneLine(to_.shapes[k].text); });
    }

    void addShapes() {
        if (!added_.empty() && changed_.empty() && removed_.empty()) {
            add("add", "\"shapes\": " + shapeTexts(added_));
        }
    }

    void addMove() {
        if (changed_.empty() || !added_.empty() || !removed_.empty()) {
            return;
        }
        std::vector<std::string> nodes;
        std::optional<Vec2> by;
        for (const auto &[shape, position] : changed_) {
            const std::vector<Vec2> from = handlesOf(*shape), to = handlesOf(*after_.shapes[position]);
            for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
                if (from[k] != to[k]) {
                    by = by.value_or(to[k] - from[k]);
                    nodes.push_back(jsonString(
                        toString(SketchPart{shape->id, SketchPartKind::Node, static_cast<std::uint32_t>(k)})));
                }
            }
        }
        if (!by) {
            return;
        }
        const std::string shapes =
            listJson(changed_, [](const auto &entry) { return std::to_string(entry.first->id); });
        const std::string list = listJson(nodes, [](const std::string &node) { return node; });
        constexpr std::size_t kMaxNodes = 100; // more say no more than the shapes themselves
        for (const char *const alone : {"", ", \"alone\": true"}) {
            const std::string shift = ", \"by\": " + pointJson(*by) + alone;
            add("move", "\"shapes\": " + shapes + shift);
            if (nodes.size() <= kMaxNodes) {
                add("move", "\"nodes\": " + list + shift);
            }
        }
    }

    void addChange() {
        std::vector<std::size_t> replaced = added_;
        for (const auto &[shape, position] : changed_) {
            replaced.push_back(position);
        }
        std::sort(replaced.begin(), replaced.end());
        std::string shapes, whole;
        if (!removed_.empty()) {
            shapes += "\"remove\": " + listJson(removed_, [](std::uint32_t id) { return std::to_string(id); });
        }
        if (!replaced.empty()) {
            shapes += (shapes.empty() ? "" : ", ") + ("\"replace\": " + shapeTexts(replaced));
        }
        whole = listJson(to_.shapes, [](const auto &shape) { return inOneLine(shape.text); });
        change(shapes, members_);
        auto members = members_;
        members.emplace_back("nextId", std::to_string(after_.nextId));
        change(shapes, members);
        members.emplace_back("shapes", whole); // in another order
        change({}, members);
    }

    void change(const std::string &shapes, const std::vector<std::pair<std::string, std::string>> &members) {
        std::string list;
        for (const auto &[name, text] : members) {
            list += (list.empty() ? "" : ", ") + jsonString(name) + ": " + text;
        }
        const std::string object = list.empty() ? "" : "\"members\": {" + list + "}";
        add("change", shapes + (shapes.empty() || object.empty() ? "" : ", ") + object);
    }

    const Document &before_, &after_;
    ProjectParts from_, to_;
    std::vector<std::size_t> added_;                                            ///< positions in after_.shapes
    std::vector<std::pair<std::shared_ptr<const Shape>, std::size_t>> changed_; ///< before; position after
    std::vector<std::uint32_t> removed_;
    std::vector<std::pair<std::string, std::string>> members_; ///< that differ
    std::vector<std::string> lines_;
};

} // namespace

std::vector<std::string> linesBetween(const Document &before, const Document &after) {
    return DocumentDifference(before, after).lines();
}

std::string newLine(const Document &document) {
    return commandLine("new", document.shapes.empty() && projectText(document) == projectText(Document())
                                  ? std::string()
                                  : "\"project\": " + inOneLine(projectText(document)));
}

} // namespace forefront
