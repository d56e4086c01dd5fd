#include "ui/dialogs/drawing_cards.hpp"

#include "ui/parts/shell.hpp"
#include "ui/platform/assets.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace forefront {
namespace {

constexpr double kMinCardWidth = 190.0, kPictureHeight = 132.0, kCardGap = 12.0; ///< design pixels
constexpr double kSmallPicture = 74.0, kSmallGap = 8.0, kTextPad = 8.0;          ///< design pixels

std::vector<std::filesystem::path> pathsOf(const std::vector<DrawingCards::Card> &cards) {
    std::vector<std::filesystem::path> paths;
    std::transform(cards.begin(), cards.end(), std::back_inserter(paths),
                   [](const DrawingCards::Card &card) { return card.path; });
    return paths;
}

/// Returns what makes the thumbnails of the cards, by their paths.
Thumbnails::Make makerOf(const std::vector<DrawingCards::Card> &cards) {
    std::map<std::filesystem::path, std::string> texts;
    for (const DrawingCards::Card &card : cards) {
        if (!card.text.empty()) {
            texts.emplace(card.path, card.text);
        }
    }
    return [texts = std::move(texts)](const std::filesystem::path &project, const std::stop_token &stop) {
        const auto text = texts.find(project);
        return text != texts.end() ? makeThumbnail(text->second, stop) : makeThumbnail(project, stop);
    };
}

/// Maps a thumbnail into a rectangle of the screen.
class Fit {
  public:
    Fit(const Box2 &box, const PixelRect &into)
        : box_(box), into_(into), zoom_(std::min(into.width / box.size().x, into.height / box.size().y)) {}
    ImVec2 operator()(Vec2 p) const {
        const Vec2 d = zoom_ * (p - box_.centre());
        return {static_cast<float>(into_.x + 0.5 * into_.width + d.x),
                static_cast<float>(into_.y + 0.5 * into_.height - d.y)};
    }

  private:
    Box2 box_;
    PixelRect into_;
    double zoom_;
};

void drawPicture(const WidgetContext &context, const Thumbnail &thumbnail, const PixelRect &into) {
    if (thumbnail.elements.empty()) {
        return;
    }
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const Fit fit(thumbnail.box, into);
    std::vector<ImVec2> nodes;
    std::transform(thumbnail.nodes.begin(), thumbnail.nodes.end(), std::back_inserter(nodes), fit);
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill; // its seams would show between the elements
    for (std::size_t i = 0; i < thumbnail.elements.size(); ++i) {
        const auto &[a, b, c] = thumbnail.elements[i];
        list.AddTriangleFilled(nodes[a], nodes[b], nodes[c], spacingColour(static_cast<double>(thumbnail.fineness[i])));
    }
    list.Flags = flags;
    for (const auto &[a, b] : thumbnail.edges) {
        list.AddLine(nodes[a], nodes[b], rgb(0x0b1018, 0.35), context.px(0.75));
    }
    for (const auto &[a, b] : thumbnail.boundary) {
        list.AddLine(nodes[a], nodes[b], context.theme.boundary, context.px(1.25));
    }
}

} // namespace

std::vector<DrawingCards::Card> sampleCards() {
    const std::vector<Sample> all = sampleDrawings();
    std::vector<DrawingCards::Card> cards;
    std::transform(all.begin(), all.end(), std::back_inserter(cards), [](const Sample &sample) {
        return DrawingCards::Card{sample.title, sample.about, sample.path};
    });
    return cards;
}

DrawingCards::DrawingCards(BackgroundList &list, std::vector<Card> cards)
    : cards_(std::move(cards)), thumbnails_(list, pathsOf(cards_), makerOf(cards_)) {}

bool DrawingCards::drawCard(Shell &context, std::size_t index, const std::string &name, float width, bool small) {
    const Card &card = cards_[index];
    const float picture = context.px(small ? kSmallPicture : kPictureHeight);
    const float words = imgui::lineOf(*context.fonts.strong) + context.px(20) +
                        (small ? 0.0F : 2.0F * imgui::lineOf(*context.fonts.small) + context.px(6));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, picture + words};
    const bool pressed = ui::hitArea(name.c_str(), size.x, size.y);
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, hovered ? context.theme.hovered : context.theme.raised,
                       context.px(6));
    const double pad = static_cast<double>(context.px(10));
    const PixelRect inside{static_cast<double>(at.x) + pad, static_cast<double>(at.y) + pad,
                           static_cast<double>(size.x) - 2.0 * pad, static_cast<double>(picture) - pad};
    if (const std::shared_ptr<const Thumbnail> thumbnail = thumbnails_.at(index)) {
        drawPicture(context, *thumbnail, inside);
    }
    const float left = at.x + context.px(kTextPad), room = size.x - context.px(2.0 * kTextPad);
    float y = at.y + picture + context.px(8);
    ImGui::PushFont(context.fonts.strong);
    ui::shortened(context, Pixel(left, y), left + room, card.title, context.theme.text);
    ImGui::PopFont();
    if (!small) {
        y += imgui::lineOf(*context.fonts.strong) + context.px(2);
        ImGui::PushFont(context.fonts.small);
        list.AddText({left, y}, context.theme.muted, ui::twoLines(card.about, room).c_str());
        ImGui::PopFont();
    } else {
        ui::tooltip(context, card.about);
    }
    return pressed;
}

std::optional<std::size_t> DrawingCards::draw(Shell &context, const std::string &prefix, std::size_t columns) {
    if (thumbnails_.refresh()) {
        context.animate();
    }
    const bool small = columns > 0;
    const float room = ImGui::GetContentRegionAvail().x, gap = context.px(small ? kSmallGap : kCardGap);
    if (!small) {
        columns = static_cast<std::size_t>(std::max(1.0F, (room + gap) / (context.px(kMinCardWidth) + gap)));
    }
    const float width = (room + gap) / static_cast<float>(columns) - gap;
    std::optional<std::size_t> chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    for (std::size_t k = 0; k < cards_.size(); ++k) {
        if (k % columns != 0) {
            ImGui::SameLine();
        }
        if (drawCard(context, k, prefix + cards_[k].path.stem().string(), width, small)) {
            chosen = k;
        }
    }
    ImGui::PopStyleVar();
    return chosen;
}

} // namespace forefront
