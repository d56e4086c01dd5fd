#include "core/drawing_files/svg/style/svg_css.hpp"

#include "core/drawing_files/svg/style/svg_colour.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kMaxDepth = 128;         ///< number of elements around one that are looked at, for hostile files
constexpr std::size_t kLongestValue = 100'000; ///< bounds the growth by variables
// Weights of declarations: elements count 1.
constexpr std::int64_t kClassWeight = std::int64_t{1} << 20;
constexpr std::int64_t kIdWeight = std::int64_t{1} << 40;
constexpr std::int64_t kInlineWeight = std::int64_t{1} << 60;
constexpr std::int64_t kImportantWeight = std::int64_t{1} << 61;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool isNameByte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// Returns the text with comments replaced by blanks.
std::string withoutComments(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        if (text.substr(at, 2) == "/*") {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string_view::npos ? text.size() : end + 2;
            result += ' ';
        } else {
            result += text[at++];
        }
    }
    return result;
}

/// Returns the end of the block that opens at `open`: its closing brace, or the end of the text.
std::size_t blockEnd(std::string_view text, std::size_t open) {
    int depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
        if (depth == 0) {
            return at;
        }
    }
    return text.size();
}

bool hasClass(std::string_view list, std::string_view name) {
    for (std::size_t at = list.find(name); at != std::string_view::npos; at = list.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || kBlanks.find(list[at - 1]) != std::string_view::npos) &&
            (end == list.size() || kBlanks.find(list[end]) != std::string_view::npos)) {
            return true;
        }
    }
    return false;
}

} // namespace

std::int64_t SvgStyles::Selector::specificity() const {
    std::int64_t weight = 0; // ids, then classes, then elements
    for (const Compound &compound : compounds) {
        weight += (compound.id.empty() ? 0 : kIdWeight) +
                  kClassWeight * static_cast<std::int64_t>(compound.classes.size() + (compound.isRoot ? 1 : 0)) +
                  (compound.element.empty() ? 0 : 1);
    }
    return weight;
}

bool SvgStyles::Compound::matches(const pugi::xml_node &node) const {
    const std::string_view list = node.attribute("class").value();
    return (!isRoot || node.parent().type() == pugi::node_document) &&
           (element.empty() || element == localName(node)) && (id.empty() || id == node.attribute("id").value()) &&
           std::all_of(classes.begin(), classes.end(), [&](const std::string &name) { return hasClass(list, name); });
}

/// Visits the elements around the node from the outermost inwards, and keeps which compounds, with all before them,
/// have matched the last of these elements, and which have matched any: bit k for compound k.
bool SvgStyles::Selector::matches(const pugi::xml_node &node, std::span<const pugi::xml_node> around) const {
    if (!compounds.back().matches(node)) {
        return false;
    }
    std::uint32_t parent = 0, any = 0;
    const auto follows = [&](std::size_t k) {
        return k == 0 || (((compounds[k].isChild ? parent : any) >> (k - 1)) & 1U) != 0;
    };
    for (auto at = around.rbegin(); at != around.rend() && compounds.size() > 1; ++at) {
        std::uint32_t own = 0;
        for (std::size_t k = 0; k + 1 < compounds.size(); ++k) {
            own |= follows(k) && compounds[k].matches(*at) ? std::uint32_t{1} << k : 0U;
        }
        any |= own;
        parent = own;
    }
    return follows(compounds.size() - 1);
}

/// Returns the declarations for a node with their weights. Those of recent nodes are kept: callers ask for one property
/// after another, and for the variables of the elements around.
const std::vector<SvgStyles::Weighted> &SvgStyles::declarationsFor(const pugi::xml_node &node) const {
    if (const auto known = recent_.find(node.hash_value()); known != recent_.end()) {
        return known->second;
    }
    constexpr std::size_t kMaxRecent = 4096;
    if (recent_.size() >= kMaxRecent) {
        recent_.clear();
    }
    std::vector<pugi::xml_node> around;
    for (pugi::xml_node at = node.parent(); at.type() == pugi::node_element && around.size() < kMaxDepth;) {
        around.push_back(at);
        at = at.parent();
    }
    std::vector<Weighted> &found = recent_[node.hash_value()];
    const auto offer = [&](const std::vector<Declaration> &declarations, std::int64_t weight) {
        for (const Declaration &declaration : declarations) {
            found.push_back({declaration, weight + (declaration.important ? kImportantWeight : 0)});
        }
    };
    for (const Rule &rule : rules_) {
        if (rule.selector.matches(node, around)) {
            offer(rule.declarations, rule.selector.specificity());
        }
    }
    if (const pugi::xml_attribute style = node.attribute("style")) {
        offer(declarationsOf(withoutComments(style.value())), kInlineWeight);
    }
    return found;
}

std::vector<SvgStyles::Declaration> SvgStyles::declarationsOf(std::string_view text) {
    std::vector<Declaration> declarations;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view item = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = item.find(':');
        if (colon == std::string_view::npos) {
            continue;
        }
        Declaration declaration;
        declaration.property = lowerCase(trimmed(item.substr(0, colon)));
        std::string_view value = trimmed(item.substr(colon + 1));
        const std::size_t mark = value.rfind('!');
        if (mark != std::string_view::npos && lowerCase(trimmed(value.substr(mark + 1))) == "important") {
            declaration.important = true;
            value = trimmed(value.substr(0, mark));
        }
        declaration.value = std::string(value);
        declarations.push_back(std::move(declaration));
    }
    return declarations;
}

bool SvgStyles::parseSelector(std::string_view text, Selector &selector) {
    constexpr std::size_t kMaxCompounds = 20;
    bool isChild = false;
    while (!(text = trimmed(text)).empty()) {
        if (text.front() == '>') {
            if (isChild || selector.compounds.empty()) {
                return false;
            }
            isChild = true;
            text.remove_prefix(1);
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(std::string(kBlanks) + '>'), text.size());
        Compound compound;
        compound.isChild = std::exchange(isChild, false);
        if (selector.compounds.size() == kMaxCompounds || !parseCompound(text.substr(0, end), compound)) {
            return false;
        }
        selector.compounds.push_back(std::move(compound));
        text.remove_prefix(end);
    }
    return !isChild && !selector.compounds.empty();
}

bool SvgStyles::parseCompound(std::string_view text, Compound &compound) {
    std::size_t at = 0;
    const auto name = [&] {
        const std::size_t begin = at;
        while (at < text.size() && isNameByte(text[at])) {
            ++at;
        }
        return std::string(text.substr(begin, at - begin));
    };
    if (text.starts_with('*')) {
        ++at;
    } else {
        compound.element = name();
    }
    while (at < text.size()) {
        const char kind = text[at++];
        const std::string given = name();
        if (kind == ':' && given == "root") {
            compound.isRoot = true;
        } else if (kind == '.' && !given.empty()) {
            compound.classes.push_back(given);
        } else if (kind == '#' && !given.empty() && compound.id.empty()) {
            compound.id = given;
        } else {
            return false;
        }
    }
    return true;
}

void SvgStyles::addSheet(std::string_view css, const std::function<void(const std::string &)> &unsupported) {
    std::string clean = withoutComments(css);
    for (const std::string_view mark : {"<!--", "-->"}) { // legal around a style sheet in HTML and SVG
        for (std::size_t at = clean.find(mark); at != std::string::npos; at = clean.find(mark)) {
            clean.erase(at, mark.size());
        }
    }
    std::string_view text = clean;
    while (!(text = trimmed(text)).empty()) {
        const std::size_t open = std::min(text.find('{'), text.size());
        if (text.starts_with('@')) { // a block, or a statement that ends with a semicolon
            const std::size_t semicolon = std::min(text.find(';'), text.size());
            unsupported(std::string(text.substr(0, text.find_first_of(" \t\r\n{;"))));
            text.remove_prefix(std::min((semicolon < open ? semicolon : blockEnd(text, open)) + 1, text.size()));
            continue;
        }
        const std::size_t end = blockEnd(text, open);
        std::string_view selectors = text.substr(0, open);
        std::string_view body = open < text.size() ? text.substr(open + 1, end - open - 1) : std::string_view();
        if (const std::size_t nested = body.find('{'); nested != std::string_view::npos) {
            unsupported(std::string(trimmed(selectors)) + " { ... { ... } }");
            body = body.substr(0, body.substr(0, nested).find_last_of(';') + 1); // what precedes the nested rule
        }
        text.remove_prefix(std::min(end + 1, text.size()));
        while (!selectors.empty()) {
            const std::size_t comma = std::min(selectors.find(','), selectors.size());
            const std::string_view one = trimmed(selectors.substr(0, comma));
            selectors.remove_prefix(std::min(comma + 1, selectors.size()));
            Rule rule;
            if (parseSelector(one, rule.selector)) {
                rule.declarations = declarationsOf(body);
                rules_.push_back(std::move(rule));
            } else {
                unsupported(std::string(one));
            }
        }
    }
}

std::string SvgStyles::value(const pugi::xml_node &node, std::string_view property) const {
    return lowerCase(valueAsWritten(node, property));
}

std::string SvgStyles::valueAsWritten(const pugi::xml_node &node, std::string_view property) const {
    return resolved(node, declared(node, property));
}

/// Replaces var(--name) and var(--name, fallback). A variable without a value makes the declaration void.
std::string SvgStyles::resolved(const pugi::xml_node &node, std::string value) const {
    constexpr std::string_view kOpen = "var(";
    constexpr int kMaxVariables = 16;
    for (int count = 0; count < kMaxVariables; ++count) {
        const std::size_t begin = value.find(kOpen);
        if (begin == std::string::npos) {
            return value;
        }
        std::size_t end = begin + kOpen.size();
        for (int depth = 1; end < value.size() && depth > 0; ++end) {
            depth += value[end] == '(' ? 1 : value[end] == ')' ? -1 : 0;
        }
        const std::string_view inside =
            std::string_view(value).substr(begin + kOpen.size(), end - begin - kOpen.size() - 1);
        const std::size_t comma = std::min(inside.find(','), inside.size());
        std::string given = variable(node, lowerCase(trimmed(inside.substr(0, comma))));
        if (given.empty() && comma < inside.size()) {
            given = trimmed(inside.substr(comma + 1));
        }
        if (given.empty() || given.size() + value.size() > kLongestValue) {
            return {};
        }
        value.replace(begin, end - begin, given);
    }
    return {}; // variables that refer to themselves
}

/// Returns the value of a variable, which elements inherit.
std::string SvgStyles::variable(const pugi::xml_node &node, std::string_view name) const {
    pugi::xml_node at = node;
    for (std::size_t depth = 0; depth < kMaxDepth && at.type() == pugi::node_element; ++depth, at = at.parent()) {
        if (std::string value = declared(at, name); !value.empty()) {
            return value;
        }
    }
    return {};
}

/// Returns the value of a property by the order of precedence: the attribute of that name, then the rules, then the
/// attribute `style`. Paints that are invalid do not count.
std::string SvgStyles::declared(const pugi::xml_node &node, std::string_view property) const {
    const bool paint = property == "fill" || property == "stroke";
    const auto counts = [&](std::string_view value) {
        return !paint || value.find("var(") != value.npos || isPaint(lowerCase(value));
    };
    std::string result(trimmed(node.attribute(std::string(property).c_str()).value()));
    if (!counts(result)) {
        result.clear();
    }
    std::int64_t best = -1;
    for (const Weighted &offered : declarationsFor(node)) {
        if (offered.declaration.property == property && offered.weight >= best && counts(offered.declaration.value)) {
            best = offered.weight;
            result = offered.declaration.value;
        }
    }
    return result;
}

} // namespace forefront
