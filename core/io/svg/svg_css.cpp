#include "core/io/svg/svg_css.hpp"

#include "core/base/lower_case.hpp"
#include "core/io/svg/svg_elements.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace forefront {

namespace {

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

int SvgStyles::Selector::specificity() const {
    int weight = 0;
    for (const Compound &compound : compounds) {
        weight += (compound.id.empty() ? 0 : 10'000) +
                  100 * static_cast<int>(std::min<std::size_t>(compound.classes.size(), 9)) +
                  (compound.element.empty() ? 0 : 1);
    }
    return weight;
}

bool SvgStyles::Compound::matches(const pugi::xml_node &node) const {
    const std::string_view list = node.attribute("class").value();
    return (element.empty() || element == localName(node)) && (id.empty() || id == node.attribute("id").value()) &&
           std::all_of(classes.begin(), classes.end(), [&](const std::string &name) { return hasClass(list, name); });
}

bool SvgStyles::Selector::matches(const pugi::xml_node &node) const {
    return compounds.back().matches(node) && (compounds.size() == 1 || matchesInside(node));
}

/// Returns true if elements around the node match the compounds before the last one: from the outermost element
/// inwards, keeps which compounds have been matched, with all before them, by the parent and by any element around.
bool SvgStyles::Selector::matchesInside(const pugi::xml_node &node) const {
    constexpr std::size_t kDepth = 100; // bounds the time for hostile files
    std::vector<pugi::xml_node> around;
    for (pugi::xml_node at = node.parent(); at.type() == pugi::node_element && around.size() < kDepth;) {
        around.push_back(at);
        at = at.parent();
    }
    std::vector<bool> parent(compounds.size()), any(compounds.size());
    const auto follows = [&](std::size_t k) { return k == 0 || (compounds[k].isChild ? parent[k - 1] : any[k - 1]); };
    for (auto at = around.rbegin(); at != around.rend(); ++at) {
        std::vector<bool> own(compounds.size());
        for (std::size_t k = 0; k + 1 < compounds.size(); ++k) {
            own[k] = follows(k) && compounds[k].matches(*at);
        }
        std::transform(own.begin(), own.end(), any.begin(), any.begin(), std::logical_or<>());
        parent = std::move(own);
    }
    return follows(compounds.size() - 1);
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
        const std::size_t end = std::min(text.find_first_of(" \t\r\n\f>"), text.size());
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
        if (given.empty() || (kind != '.' && kind != '#') || (kind == '#' && !compound.id.empty())) {
            return false;
        }
        if (kind == '.') {
            compound.classes.push_back(given);
        } else {
            compound.id = given;
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
        const std::string_view body = open < text.size() ? text.substr(open + 1, end - open - 1) : std::string_view();
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
    constexpr int kAttribute = -1, kInline = 1'000'000, kImportant = 10'000'000;
    std::string result(trimmed(node.attribute(std::string(property).c_str()).value()));
    int best = result.empty() ? kAttribute - 1 : kAttribute;
    const auto offer = [&](const std::vector<Declaration> &declarations, int weight) {
        for (const Declaration &declaration : declarations) {
            const int own = weight + (declaration.important ? kImportant : 0);
            if (declaration.property == property && own >= best) {
                best = own;
                result = declaration.value;
            }
        }
    };
    for (const Rule &rule : rules_) {
        if (rule.selector.matches(node)) {
            offer(rule.declarations, rule.selector.specificity());
        }
    }
    if (const pugi::xml_attribute style = node.attribute("style")) {
        offer(declarationsOf(withoutComments(style.value())), kInline);
    }
    return result;
}

} // namespace forefront
