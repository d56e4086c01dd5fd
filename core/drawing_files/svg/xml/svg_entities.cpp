#include "core/drawing_files/svg/xml/svg_entities.hpp"

#include "core/drawing_files/svg/xml/svg_elements.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

using Entities = std::map<std::string, std::string, std::less<>>;

/// Reads definitions such as <!ENTITY name "text">; external ones are left out.
Entities entitiesOf(std::string_view documentType) {
    constexpr std::string_view kBegin = "<!ENTITY";
    Entities entities;
    for (std::size_t at = documentType.find(kBegin); at != std::string_view::npos; at = documentType.find(kBegin, at)) {
        at += kBegin.size();
        const std::size_t name = std::min(documentType.find_first_not_of(kBlanks, at), documentType.size());
        const std::size_t end = std::min(documentType.find_first_of(kBlanks, name), documentType.size());
        const std::size_t open = std::min(documentType.find_first_not_of(kBlanks, end), documentType.size());
        if (open == documentType.size() || (documentType[open] != '"' && documentType[open] != '\'')) {
            continue;
        }
        const std::size_t close = documentType.find(documentType[open], open + 1);
        if (close == std::string_view::npos) {
            break;
        }
        entities.emplace(documentType.substr(name, end - name), documentType.substr(open + 1, close - open - 1));
        at = close;
    }
    return entities;
}

void appendEscaped(std::string_view text, std::string &result) {
    for (const char c : text) {
        result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string_view(&c, 1);
    }
}

/// Expands the entities of a document one text after another.
class EntityExpander : public pugi::xml_tree_walker {
  public:
    EntityExpander(const Entities &entities, std::size_t limit) : entities_(entities), left_(limit) {
        for (const auto &[name, text] : entities) {
            longestName_ = std::max(longestName_, name.size());
        }
    }

    bool for_each(pugi::xml_node &node) override {
        for (pugi::xml_attribute attribute : node.attributes()) {
            if (const std::string_view text = attribute.value(); text.find('&') != std::string_view::npos) {
                attribute.set_value(expanded(text).c_str());
            }
        }
        const bool isText = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
        if (const std::string_view text = node.value(); isText && text.find('&') != std::string_view::npos) {
            bringsElements_ = false;
            const std::string plain = expanded(text);
            if (bringsElements_ && node.type() == pugi::node_pcdata) {
                withElements_.emplace_back(node, expanded(text, true));
            } else {
                node.set_value(plain.c_str());
            }
        }
        return fits_;
    }

    bool fits() const { return fits_; }

    /// Replaces the texts into which entities bring elements. Returns false if one is malformed.
    bool addElements() const {
        for (const auto &[text, content] : withElements_) {
            pugi::xml_document fragment;
            if (!fragment.load_string(content.c_str(), pugi::parse_default | pugi::parse_fragment)) {
                return false;
            }
            for (const pugi::xml_node &child : fragment.children()) {
                text.parent().insert_copy_before(child, text);
            }
            text.parent().remove_child(text);
        }
        return true;
    }

  private:
    static constexpr int kMaxDepth = 8; ///< of entities within entities

    /// Returns a text with its entities expanded; as markup, text outside entities is escaped.
    std::string expanded(std::string_view text, bool asMarkup = false) {
        std::string result;
        asMarkup_ = asMarkup;
        append(text, kMaxDepth, result);
        return result;
    }

    void append(std::string_view text, int depth, std::string &result) {
        bringsElements_ = bringsElements_ || (depth < kMaxDepth && text.find('<') != std::string_view::npos);
        while (!text.empty() && fits_) {
            const std::size_t mark = std::min(text.find('&'), text.size());
            take(text.substr(0, mark), depth, result);
            text.remove_prefix(mark);
            const std::size_t end = text.substr(0, longestName_ + 2).find(';');
            const auto found =
                end == std::string_view::npos ? entities_.end() : entities_.find(text.substr(1, end - 1));
            if (found != entities_.end() && depth > 0) {
                append(found->second, depth - 1, result);
                text.remove_prefix(end + 1);
            } else if (!text.empty()) {
                take(text.substr(0, 1), depth, result);
                text.remove_prefix(1);
            }
        }
    }

    void take(std::string_view part, int depth, std::string &result) {
        fits_ = fits_ && part.size() <= left_;
        if (!fits_) {
            return;
        }
        left_ -= part.size();
        if (asMarkup_ && depth == kMaxDepth) {
            appendEscaped(part, result);
        } else {
            result += part;
        }
    }

    const Entities &entities_;
    std::size_t longestName_ = 0;
    std::vector<std::pair<pugi::xml_node, std::string>> withElements_; ///< texts and what they expand to
    std::size_t left_;
    bool fits_ = true;
    bool asMarkup_ = false, bringsElements_ = false; ///< of the present text
};

} // namespace

EntityExpansion expandEntities(pugi::xml_document &document, std::size_t limit) {
    const pugi::xml_node type =
        document.find_child([](const pugi::xml_node &n) { return n.type() == pugi::node_doctype; });
    const Entities entities = entitiesOf(type.value());
    if (entities.empty()) {
        return EntityExpansion::Done;
    }
    EntityExpander expansion(entities, limit);
    document.traverse(expansion);
    return !expansion.fits()         ? EntityExpansion::TooLarge
           : expansion.addElements() ? EntityExpansion::Done
                                     : EntityExpansion::Malformed;
}

} // namespace forefront
