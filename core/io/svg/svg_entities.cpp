#include "core/io/svg/svg_entities.hpp"

#include "core/io/svg/svg_elements.hpp"

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

/// Expands the entities of a document one text after another.
class Expansion : public pugi::xml_tree_walker {
  public:
    Expansion(const Entities &entities, std::size_t limit) : entities_(entities), left_(limit) {}

    bool for_each(pugi::xml_node &node) override {
        for (pugi::xml_attribute attribute : node.attributes()) {
            if (const std::string_view text = attribute.value(); text.find('&') != std::string_view::npos) {
                attribute.set_value(expanded(text).c_str());
            }
        }
        const bool isText = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
        if (const std::string_view text = node.value(); isText && text.find('&') != std::string_view::npos) {
            std::string replaced = expanded(text);
            node.set_value(replaced.c_str());
            if (node.type() == pugi::node_pcdata && replaced.find('<') != std::string::npos) {
                withElements_.emplace_back(node, std::move(replaced));
            }
        }
        return fits_;
    }

    bool fits() const { return fits_; }

    /// Replaces the texts in which an entity has brought elements by these. Malformed ones stay texts.
    void addElements() const {
        for (const auto &[text, content] : withElements_) {
            pugi::xml_document fragment;
            if (fragment.load_string(content.c_str(), pugi::parse_default | pugi::parse_fragment)) {
                for (const pugi::xml_node &child : fragment.children()) {
                    text.parent().insert_copy_before(child, text);
                }
                text.parent().remove_child(text);
            }
        }
    }

  private:
    static constexpr int kMaxDepth = 8; ///< of entities within entities

    std::string expanded(std::string_view text) {
        std::string result;
        append(text, kMaxDepth, result);
        return result;
    }

    void append(std::string_view text, int depth, std::string &result) {
        while (!text.empty() && fits_) {
            const std::size_t mark = std::min(text.find('&'), text.size());
            take(text.substr(0, mark), result);
            text.remove_prefix(mark);
            const std::size_t end = text.find(';');
            const auto found =
                end == std::string_view::npos ? entities_.end() : entities_.find(text.substr(1, end - 1));
            if (found != entities_.end() && depth > 0) {
                append(found->second, depth - 1, result);
                text.remove_prefix(end + 1);
            } else if (!text.empty()) {
                take(text.substr(0, 1), result);
                text.remove_prefix(1);
            }
        }
    }

    void take(std::string_view part, std::string &result) {
        fits_ = fits_ && part.size() <= left_;
        if (fits_) {
            left_ -= part.size();
            result += part;
        }
    }

    const Entities &entities_;
    std::vector<std::pair<pugi::xml_node, std::string>> withElements_; ///< texts and what they expand to
    std::size_t left_;
    bool fits_ = true;
};

} // namespace

bool expandEntities(pugi::xml_document &document, std::size_t limit) {
    const pugi::xml_node type =
        document.find_child([](const pugi::xml_node &n) { return n.type() == pugi::node_doctype; });
    const Entities entities = entitiesOf(type.value());
    if (entities.empty()) {
        return true;
    }
    Expansion expansion(entities, limit);
    document.traverse(expansion);
    if (expansion.fits()) {
        expansion.addElements();
    }
    return expansion.fits();
}

} // namespace forefront
