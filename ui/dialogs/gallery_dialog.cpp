#include "ui/dialogs/gallery_dialog.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {
namespace {

constexpr double kMinCardWidth = 190.0, kCardHeight = 196.0, kPictureHeight = 132.0, kCardGap = 12.0; ///< design pixels

std::vector<std::filesystem::path> pathsOf(const std::vector<Sample> &samples) {
    std::vector<std::filesystem::path> paths;
    std::transform(samples.begin(), samples.end(), std::back_inserter(paths), [](const Sample &s) { return s.path; });
    return paths;
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

GalleryDialog::GalleryDialog(Shell &context)
    : samples_(samples()), thumbnails_(context.background, pathsOf(samples_)) {}

bool GalleryDialog::drawCard(Shell &context, std::size_t k, float width) {
    const Sample &sample = samples_[k];
    const std::string name = "dialog/gallery/" + sample.path.stem().string();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, context.px(kCardHeight)};
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    const bool hovered = ImGui::IsItemHovered();
    ui::mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    list.AddRectFilled(at, end, hovered ? context.theme.hovered : context.theme.raised, context.px(6));
    const double pad = static_cast<double>(context.px(10));
    const PixelRect picture{static_cast<double>(at.x) + pad, static_cast<double>(at.y) + pad,
                            static_cast<double>(size.x) - 2.0 * pad,
                            static_cast<double>(context.px(kPictureHeight)) - pad};
    if (const std::shared_ptr<const Thumbnail> thumbnail = thumbnails_.at(k)) {
        drawPicture(context, *thumbnail, picture);
    }
    const float left = at.x + context.px(10), room = size.x - context.px(20);
    float y = at.y + context.px(kPictureHeight + 8);
    list.AddText(context.fonts.strong, context.fonts.strong->FontSize, {left, y}, context.theme.text,
                 sample.title.c_str());
    y += context.fonts.strong->FontSize + context.px(2);
    ImGui::PushFont(context.fonts.small);
    list.AddText({left, y}, context.theme.muted, ui::twoLines(sample.about, room).c_str());
    ImGui::PopFont();
    return pressed;
}

bool GalleryDialog::draw(Shell &context) {
    thumbnails_.refresh();
    bool open = true;
    ImGui::BeginChild("cards", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = context.px(kCardGap);
    const auto columns = static_cast<std::size_t>(std::max(1.0F, (room + gap) / (context.px(kMinCardWidth) + gap)));
    const float width = (room + gap) / static_cast<float>(columns) - gap;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(kCardGap), context.px(kCardGap)));
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        if (k % columns != 0) {
            ImGui::SameLine();
        }
        if (drawCard(context, k, width)) {
            openDocument(context, samples_[k].path);
            open = false;
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    return open;
}

} // namespace forefront
