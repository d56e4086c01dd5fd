#pragma once

#include <pugixml.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace forefront {

/// The style of SVG elements: presentation attributes, <style> blocks with selectors (element, .class, #id, *,
/// compounds of them, and descendants and children, "a b" and "a > b") and the attribute `style`, in the order of
/// precedence of CSS.
class SvgStyles {
  public:
    /// Reads the text of a <style> block. `unsupported` is called with each selector or rule that is left out.
    void addSheet(std::string_view css, const std::function<void(const std::string &)> &unsupported);

    /// Returns the value of a property as given for this element itself, in lower case; empty: not given. Variables,
    /// var(--name), are replaced by their values for the element.
    std::string value(const pugi::xml_node &node, std::string_view property) const;
    /// Returns the same value with its letter case unchanged, for values that name an id.
    std::string valueAsWritten(const pugi::xml_node &node, std::string_view property) const;

  private:
    struct Compound {
        std::string element; ///< empty: any
        std::string id;      ///< empty: any
        std::vector<std::string> classes;
        bool isRoot = false;  ///< selects only the outermost element
        bool isChild = false; ///< must be a child of the element that the previous compound selects
        bool matches(const pugi::xml_node &node) const;
    };
    struct Selector {
        std::vector<Compound> compounds; ///< from the outermost element to the one that it selects
        std::int64_t specificity() const;
        /// `around`: the elements around the node, the innermost first.
        bool matches(const pugi::xml_node &node, std::span<const pugi::xml_node> around) const;
    };
    struct Declaration {
        std::string property, value;
        bool important = false;
    };
    struct Weighted {
        Declaration declaration;
        std::int64_t weight = 0; ///< the greatest one wins, of equal ones the last
    };
    struct Rule {
        Selector selector;
        std::vector<Declaration> declarations;
    };

    const std::vector<Weighted> &declarationsFor(const pugi::xml_node &node) const;
    std::string declared(const pugi::xml_node &node, std::string_view property) const;
    std::string variable(const pugi::xml_node &node, std::string_view name) const;
    std::string resolved(const pugi::xml_node &node, std::string value) const;
    static std::vector<Declaration> declarationsOf(std::string_view text);
    static bool parseSelector(std::string_view text, Selector &selector);
    static bool parseCompound(std::string_view text, Compound &compound);

    std::vector<Rule> rules_;
    mutable std::unordered_map<std::size_t, std::vector<Weighted>>
        recent_; ///< by the hash of the node, which is unique
};

} // namespace forefront
