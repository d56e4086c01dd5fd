#include "app/batch/setting_list.hpp"

#include "app/batch/suggestion.hpp"

#include <algorithm>

namespace forefront {

bool SettingList::has(std::string_view key) const {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string readSettings(std::string_view text, const SettingRules &rules, SettingList &list) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon == 0) {
        return std::string("expected ") + rules.example;
    }
    list.name = text.substr(0, colon);
    for (std::string_view rest = text.substr(colon + 1); !rest.empty();) {
        const std::string_view item = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), item.size() + 1));
        const std::string_view key = item.substr(0, item.find('='));
        const bool known = std::find(rules.known.begin(), rules.known.end(), key) != rules.known.end();
        if (!known || key.size() == item.size()) {
            return "unknown setting '" + std::string(item) + "'; expected KEY=VALUE with " + rules.keys +
                   suggestion(key, rules.known);
        }
        if (list.has(key)) {
            return std::string(key) + " is given twice";
        }
        list.keys.push_back(key);
        if (std::string wrong = rules.set(key, item.substr(key.size() + 1)); !wrong.empty()) {
            return wrong;
        }
    }
    return {};
}

} // namespace forefront
