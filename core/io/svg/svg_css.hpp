#pragma once

#include <pugixml.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The style of SVG elements: presentation attributes, <style> blocks with selectors (element, .class, #id, *,
/// compounds of them, and those inside of others, "a b" and "a > b") and the attribute `style`, in the order of
/// precedence of CSS.
class SvgStyles {
  public:
    /// Reads the text of a <style> block. `unsupported` is called with each selector or rule that is left out.
    void addSheet(std::string_view css, const std::function<void(const std::string &)> &unsupported);

    /// Returns the value of a property as given for this element itself, in lower case; empty: not given.
    std::string value(const pugi::xml_node &node, std::string_view property) const;
    /// Returns the same as it is written, for values that name an id.
    std::string valueAsWritten(const pugi::xml_node &node, std::string_view property) const;

  private:
    struct Compound {
        std::string element; ///< empty: any
        std::string id;      ///< empty: any
        std::vector<std::string> classes;
        bool isChild = false; ///< of the compound before it, not only somewhere inside
        bool matches(const pugi::xml_node &node) const;
    };
    struct Selector {
        std::vector<Compound> compounds; ///< from the outermost element to the one that it selects
        int specificity() const;
        bool matches(const pugi::xml_node &node) const;
        bool matchesInside(const pugi::xml_node &node) const;
    };
    struct Declaration {
        std::string property, value;
        bool important = false;
    };
    struct Rule {
        Selector selector;
        std::vector<Declaration> declarations;
    };

    static std::vector<Declaration> declarationsOf(std::string_view text);
    static bool parseSelector(std::string_view text, Selector &selector);
    static bool parseCompound(std::string_view text, Compound &compound);

    std::vector<Rule> rules_;
};

} // namespace forefront
