#include "ui/dialogs/palette_dialog.hpp"

#include "ui/app/app_context.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>

namespace forefront {
namespace {

constexpr std::size_t kShown = 12;

std::string titleOf(const Action &action, const AppContext &context) {
    const std::string title = action.dynamic ? action.dynamic(context) : action.title;
    return action.menu.empty() ? title : action.menu + ": " + title;
}

} // namespace

int paletteScore(std::string_view title, std::string_view typed) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    int score = 1;
    std::size_t at = 0, last = std::string_view::npos;
    for (const char c : typed) {
        if (c == ' ') {
            continue;
        }
        // A letter at the beginning of a word is taken before one inside, if there is one.
        std::size_t found = std::string_view::npos;
        for (std::size_t k = at; k < title.size(); ++k) {
            if (lower(title[k]) != lower(c)) {
                continue;
            }
            const bool begins = k == 0 || title[k - 1] == ' ';
            const bool follows = last != std::string_view::npos && k == last + 1;
            if (begins || follows) {
                found = k;
                score += follows ? 6 : 4;
                break;
            }
            if (found == std::string_view::npos) {
                found = k;
            }
        }
        if (found == std::string_view::npos) {
            return 0;
        }
        ++score;
        last = found;
        at = found + 1;
    }
    return score;
}

std::vector<const Action *> PaletteDialog::matches(const AppContext &context) const {
    std::vector<std::pair<int, const Action *>> scored;
    for (const Action &action : context.actions.all()) {
        if (action.id == "view.palette") {
            continue;
        }
        const int score = paletteScore(titleOf(action, context), typed_);
        if (score > 0) {
            scored.emplace_back(score, &action);
        }
    }
    std::stable_sort(scored.begin(), scored.end(), [](const auto &a, const auto &b) { return a.first > b.first; });
    std::vector<const Action *> result;
    for (const auto &[score, action] : scored) {
        result.push_back(action);
    }
    return result;
}

bool PaletteDialog::draw(AppContext &context) {
    const std::string before = typed_;
    const bool entered =
        ui::inputText(context, "dialog/palette/filter", typed_, "a few letters of what you want", -1.0F, true, focus_);
    focus_ = false;
    if (typed_ != before) {
        chosen_ = 0;
    }
    const std::vector<const Action *> found = matches(context);
    const int last = static_cast<int>(found.size()) - 1;
    chosen_ += (ImGui::IsKeyPressed(key::kDown) ? 1 : 0) - (ImGui::IsKeyPressed(key::kUp) ? 1 : 0);
    chosen_ = std::clamp(chosen_, 0, std::max(0, last));
    const Action *run = nullptr;
    ImGui::BeginChild("list", {0, context.px(27.0 * static_cast<double>(kShown))}, false, ImGuiWindowFlags_NoNav);
    for (int k = 0; k <= last; ++k) {
        const Action &action = *found[static_cast<std::size_t>(k)];
        const bool enabled = !action.enabled || action.enabled(context);
        const std::string keys = action.shortcuts.empty() ? std::string() : toString(action.shortcuts.front());
        ImGui::BeginDisabled(!enabled);
        if (ui::selectable(context, "dialog/palette/item/" + action.id, titleOf(action, context), k == chosen_, keys)) {
            run = &action;
        }
        ImGui::EndDisabled();
        if (k == chosen_ && typed_ == before && ImGui::IsKeyPressed(k == chosen_ ? key::kDown : key::kUp)) {
            ImGui::SetScrollHereY(0.5F);
        }
        if (k == chosen_ && entered && enabled) {
            run = &action;
        }
    }
    if (found.empty()) {
        ui::muted(context, "Nothing is called so");
    }
    ImGui::EndChild();
    if (run != nullptr) {
        const std::string id = run->id;
        context.actions.run(id, context);
        return false;
    }
    return true;
}

} // namespace forefront
