#include "ui/style/imgui_versions.hpp"

#include "ui/input/keys.hpp"

#include <imgui_freetype.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

#if IMGUI_VERSION_NUM >= 18700 && IMGUI_VERSION_NUM < 19140
#error "Dear ImGui 1.86, or 1.91.4 or later is needed"
#endif

namespace forefront::imgui {

// Fonts. From 1.92 on, characters are rasterised when they are first drawn, for each size that is used.

#if IMGUI_VERSION_NUM >= 19200

float lineOf(const ImFont &font) {
    return font.LegacySize;
}

bool holds(ImFont &font, unsigned code) {
    return font.IsGlyphInFont(static_cast<ImWchar>(code));
}

void useFreeType(ImFontAtlas &atlas) {
    atlas.SetFontLoader(ImGuiFreeType::GetFontLoader());
    atlas.FontLoaderFlags = ImGuiFreeTypeLoaderFlags_LightHinting;
    atlas.TexGlyphPadding = 1;
}

int reserveGlyph(ImFontAtlas &atlas, ImFont &font, float line, unsigned code, int size, float top) {
    return atlas.AddCustomRectFontGlyphForSize(&font, line, static_cast<ImWchar>(code), size, size,
                                               static_cast<float>(size), ImVec2(0.0F, top));
}

void build(ImFontAtlas &) {}

void drawInto(ImFontAtlas &atlas, int number, std::span<const unsigned char> cover) {
    ImFontAtlasRect rect{};
    if (!atlas.GetCustomRect(number, &rect)) {
        return;
    }
    for (int row = 0; row < rect.h; ++row) {
        const unsigned char *from = cover.data() + static_cast<std::size_t>(row) * rect.w;
        auto *to = static_cast<unsigned char *>(atlas.TexData->GetPixelsAt(rect.x, rect.y + row));
        for (int column = 0; column < rect.w; ++column, ++from, to += atlas.TexData->BytesPerPixel) {
            std::fill_n(to, atlas.TexData->BytesPerPixel - 1,
                        static_cast<unsigned char>(0xff)); // white, if it has colours
            to[atlas.TexData->BytesPerPixel - 1] = *from;
        }
    }
}

static ImFontBaked &glyphsOf(ImFont &font) {
    return *font.GetFontBaked(font.LegacySize);
}

void uploadFonts() {} // the renderer does when it finds them changed

#else

float lineOf(const ImFont &font) {
    return font.FontSize;
}

bool holds(ImFont &font, unsigned code) {
    return font.FindGlyphNoFallback(static_cast<ImWchar>(code)) != nullptr;
}

void useFreeType(ImFontAtlas &atlas) {
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    atlas.TexGlyphPadding = 1;
}

int reserveGlyph(ImFontAtlas &atlas, ImFont &font, float, unsigned code, int size, float top) {
    return atlas.AddCustomRectFontGlyph(&font, static_cast<ImWchar>(code), size, size, static_cast<float>(size),
                                        ImVec2(0.0F, top));
}

void build(ImFontAtlas &atlas) {
    atlas.Build();
}

void drawInto(ImFontAtlas &atlas, int number, std::span<const unsigned char> cover) {
    const ImFontAtlasCustomRect &rect = *atlas.GetCustomRectByIndex(number);
    for (int row = 0; row < rect.Height; ++row) {
        std::copy_n(cover.begin() + static_cast<std::ptrdiff_t>(row) * rect.Width, rect.Width,
                    atlas.TexPixelsAlpha8 + (rect.Y + row) * atlas.TexWidth + rect.X);
    }
}

static ImFont &glyphsOf(ImFont &font) {
    return font;
}

void uploadFonts() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

#endif

GlyphInk inkOf(ImFont &font, unsigned code) {
    const ImFontGlyph *const glyph = glyphsOf(font).FindGlyph(static_cast<ImWchar>(code));
    return glyph == nullptr ? GlyphInk() : GlyphInk{glyph->Y0, glyph->Y1, glyph->AdvanceX};
}

float baselineOf(ImFont &font) {
    return glyphsOf(font).Ascent;
}

void drawTexture(ImDrawList &list, unsigned texture, ImVec2 min, ImVec2 max) {
    // ImTextureID is a pointer in some versions, and a number in others.
    list.AddImage((ImTextureID) static_cast<std::uintptr_t>(texture), min, max);
}

void makeTabular(ImFont &font, unsigned first, unsigned last) {
    auto &baked = glyphsOf(font);
    float widest = 0.0F;
    for (unsigned code = first; code <= last; ++code) {
        widest = std::max(widest, baked.GetCharAdvance(static_cast<ImWchar>(code)));
    }
    for (unsigned code = first; code <= last; ++code) {
        const ImFontGlyph *const found = baked.FindGlyphNoFallback(static_cast<ImWchar>(code));
        if (found == nullptr) {
            continue;
        }
        ImFontGlyph &glyph = baked.Glyphs[static_cast<int>(found - baked.Glyphs.Data)];
        const float shift = std::round(0.5F * (widest - glyph.AdvanceX)); // whole pixels keep the digit sharp
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
        baked.IndexAdvanceX[static_cast<int>(code)] = widest;
    }
}

// Keys. Later versions have codes of its own, and events in place of a table of the keys that are down.

#if IMGUI_VERSION_NUM >= 19140

namespace {

/// Returns Dear ImGui's code of a key; ImGuiKey_None for those that it does not know.
ImGuiKey imguiKey(int code) {
    constexpr struct {
        int code;
        ImGuiKey key;
    } kKeys[] = {{key::kSpace, ImGuiKey_Space},
                 {key::kApostrophe, ImGuiKey_Apostrophe},
                 {key::kComma, ImGuiKey_Comma},
                 {key::kMinus, ImGuiKey_Minus},
                 {key::kPeriod, ImGuiKey_Period},
                 {key::kSlash, ImGuiKey_Slash},
                 {key::kEqual, ImGuiKey_Equal},
                 {key::kLeftBracket, ImGuiKey_LeftBracket},
                 {key::kRightBracket, ImGuiKey_RightBracket},
                 {key::kEscape, ImGuiKey_Escape},
                 {key::kEnter, ImGuiKey_Enter},
                 {key::kTab, ImGuiKey_Tab},
                 {key::kBackspace, ImGuiKey_Backspace},
                 {key::kInsert, ImGuiKey_Insert},
                 {key::kDelete, ImGuiKey_Delete},
                 {key::kRight, ImGuiKey_RightArrow},
                 {key::kLeft, ImGuiKey_LeftArrow},
                 {key::kDown, ImGuiKey_DownArrow},
                 {key::kUp, ImGuiKey_UpArrow},
                 {key::kPageUp, ImGuiKey_PageUp},
                 {key::kPageDown, ImGuiKey_PageDown},
                 {key::kHome, ImGuiKey_Home},
                 {key::kEnd, ImGuiKey_End},
                 {key::kKeypadDecimal, ImGuiKey_KeypadDecimal},
                 {key::kKeypadEnter, ImGuiKey_KeypadEnter},
                 {key::kLeftShift, ImGuiKey_LeftShift},
                 {key::kLeftControl, ImGuiKey_LeftCtrl},
                 {key::kLeftAlt, ImGuiKey_LeftAlt},
                 {key::kLeftSuper, ImGuiKey_LeftSuper},
                 {key::kRightShift, ImGuiKey_RightShift},
                 {key::kRightControl, ImGuiKey_RightCtrl},
                 {key::kRightAlt, ImGuiKey_RightAlt},
                 {key::kRightSuper, ImGuiKey_RightSuper}};
    constexpr struct {
        int first, last;
        ImGuiKey key; ///< of the first
    } kRows[] = {{key::k0, key::k9, ImGuiKey_0},
                 {'A', 'Z', ImGuiKey_A},
                 {key::kF1, key::kF1 + 11, ImGuiKey_F1},
                 {key::kKeypad0, key::kKeypad9, ImGuiKey_Keypad0}};
    for (const auto &row : kRows) {
        if (code >= row.first && code <= row.last) {
            return static_cast<ImGuiKey>(static_cast<int>(row.key) + code - row.first);
        }
    }
    const auto *const found =
        std::find_if(std::begin(kKeys), std::end(kKeys), [code](const auto &each) { return each.code == code; });
    return found != std::end(kKeys) ? found->key : ImGuiKey_None;
}

} // namespace

void mapKeys() {
    ImGui::GetIO().ConfigInputTrickleEventQueue = false; // all events of a frame count in it
}

void feedKey(int code, bool pressed, bool repeated) {
    const ImGuiKey known = imguiKey(code);
    if (known == ImGuiKey_None) {
        return;
    }
    ImGuiIO &io = ImGui::GetIO();
    io.AddKeyEvent(known, pressed);
    constexpr struct {
        ImGuiKey left, right, modifier;
    } kModifiers[] = {{ImGuiKey_LeftCtrl, ImGuiKey_RightCtrl, ImGuiMod_Ctrl},
                      {ImGuiKey_LeftShift, ImGuiKey_RightShift, ImGuiMod_Shift},
                      {ImGuiKey_LeftAlt, ImGuiKey_RightAlt, ImGuiMod_Alt}};
    for (const auto &each : kModifiers) {
        if (known == each.left || known == each.right) {
            io.AddKeyEvent(each.modifier, pressed || ImGui::IsKeyDown(known == each.left ? each.right : each.left));
        }
    }
    if (pressed && repeated) {
        ImGui::GetKeyData(known)->DownDuration = -1.0F; // pressed anew
    }
}

void releaseKeys() {
    ImGui::GetIO().ClearInputKeys();
}

void feedEnterToMenu() {} // Enter does it by itself

bool keyPressed(int code, bool repeats) {
    const ImGuiKey known = imguiKey(code);
    return known != ImGuiKey_None && ImGui::IsKeyPressed(known, repeats);
}

bool keyHeld(int code) {
    const ImGuiKey known = imguiKey(code);
    return known != ImGuiKey_None && ImGui::IsKeyDown(known);
}

RedoByShiftZ::RedoByShiftZ() : swapped_(false) {}
RedoByShiftZ::~RedoByShiftZ() = default;

#else

void mapKeys() {
    constexpr struct {
        ImGuiKey key;
        int code;
    } kKeys[] = {{ImGuiKey_Tab, key::kTab},
                 {ImGuiKey_LeftArrow, key::kLeft},
                 {ImGuiKey_RightArrow, key::kRight},
                 {ImGuiKey_UpArrow, key::kUp},
                 {ImGuiKey_DownArrow, key::kDown},
                 {ImGuiKey_PageUp, key::kPageUp},
                 {ImGuiKey_PageDown, key::kPageDown},
                 {ImGuiKey_Home, key::kHome},
                 {ImGuiKey_End, key::kEnd},
                 {ImGuiKey_Insert, key::kInsert},
                 {ImGuiKey_Delete, key::kDelete},
                 {ImGuiKey_Backspace, key::kBackspace},
                 {ImGuiKey_Space, key::kSpace},
                 {ImGuiKey_Enter, key::kEnter},
                 {ImGuiKey_Escape, key::kEscape},
                 {ImGuiKey_KeyPadEnter, key::kKeypadEnter},
                 {ImGuiKey_A, 'A'},
                 {ImGuiKey_C, 'C'},
                 {ImGuiKey_V, 'V'},
                 {ImGuiKey_X, 'X'},
                 {ImGuiKey_Y, 'Y'},
                 {ImGuiKey_Z, 'Z'}};
    for (const auto &each : kKeys) {
        ImGui::GetIO().KeyMap[each.key] = each.code;
    }
}

void feedKey(int code, bool pressed, bool repeated) {
    ImGuiIO &io = ImGui::GetIO();
    if (code >= 0 && code < IM_ARRAYSIZE(io.KeysDown)) {
        io.KeysDown[code] = pressed;
        if (pressed && repeated) {
            io.KeysDownDuration[code] = -1.0F; // pressed anew
        }
    }
    io.KeyCtrl = io.KeysDown[key::kLeftControl] || io.KeysDown[key::kRightControl];
    io.KeyShift = io.KeysDown[key::kLeftShift] || io.KeysDown[key::kRightShift];
    io.KeyAlt = io.KeysDown[key::kLeftAlt] || io.KeysDown[key::kRightAlt];
}

void releaseKeys() {
    ImGuiIO &io = ImGui::GetIO();
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
}

void feedEnterToMenu() {
    ImGuiIO &io = ImGui::GetIO();
    if (io.KeysDown[key::kEnter] || io.KeysDown[key::kKeypadEnter]) {
        io.NavInputs[ImGuiNavInput_Activate] = 1.0F;
    }
}

bool keyPressed(int code, bool repeats) {
    return ImGui::IsKeyPressed(code, repeats);
}

bool keyHeld(int code) {
    return ImGui::GetIO().KeysDown[code];
}

namespace {

void swapZAndY() {
    ImGuiIO &io = ImGui::GetIO();
    std::swap(io.KeyMap[ImGuiKey_Z], io.KeyMap[ImGuiKey_Y]);
}

} // namespace

RedoByShiftZ::RedoByShiftZ() {
    ImGuiIO &io = ImGui::GetIO();
    swapped_ = io.KeyCtrl && io.KeyShift && io.KeysDown[io.KeyMap[ImGuiKey_Z]];
    if (swapped_) {
        swapZAndY();
        io.KeyShift = false;
        io.KeyMods &= ~ImGuiKeyModFlags_Shift;
    }
}

RedoByShiftZ::~RedoByShiftZ() {
    if (swapped_) {
        swapZAndY();
        ImGui::GetIO().KeyShift = true;
        ImGui::GetIO().KeyMods |= ImGuiKeyModFlags_Shift;
    }
}

#endif

// Fields, text and highlights, of which some versions changed the internals.

std::pair<std::size_t, std::size_t> selectedBytes(const ImGuiInputTextState &field) {
#if IMGUI_VERSION_NUM >= 19140
    const auto [low, high] = std::minmax(field.GetSelectionStart(), field.GetSelectionEnd());
    return {static_cast<std::size_t>(low), static_cast<std::size_t>(high)};
#else
    const auto [low, high] = std::minmax(field.Stb.select_start, field.Stb.select_end);
    const ImWchar *const letters = field.TextW.Data; // the selection counts letters, the text has bytes
    return {static_cast<std::size_t>(ImTextCountUtf8BytesFromStr(letters, letters + low)),
            static_cast<std::size_t>(ImTextCountUtf8BytesFromStr(letters, letters + high))};
#endif
}

void textUpTo(ImVec2 corner, float right, const char *begin, const char *end, ImVec2 size) {
    ImDrawList *const list = ImGui::GetWindowDrawList();
    const ImVec2 opposite{right, corner.y + size.y};
#if IMGUI_VERSION_NUM >= 19200
    ImGui::RenderTextEllipsis(list, corner, opposite, right, begin, end, &size);
#else
    ImGui::RenderTextEllipsis(list, corner, opposite, right, right, begin, end, &size);
#endif
}

void highlightItem(ImGuiID id, ImVec2 min, ImVec2 max) {
    ImGuiContext &imgui = *ImGui::GetCurrentContext();
#if IMGUI_VERSION_NUM >= 19140
    ImGui::SetNavID(id, ImGuiNavLayer_Main, imgui.CurrentFocusScopeId, {min, max});
    imgui.NavCursorVisible = true;
    imgui.NavHighlightItemUnderNav = true;
#else
    ImGui::SetNavID(id, ImGuiNavLayer_Main, imgui.CurrentWindow->DC.NavFocusScopeIdCurrent, {min, max});
    imgui.NavDisableHighlight = false;
    imgui.NavDisableMouseHover = true;
#endif
}

bool anyHighlight() {
#if IMGUI_VERSION_NUM >= 19140
    return ImGui::GetCurrentContext()->NavCursorVisible;
#else
    return !ImGui::GetCurrentContext()->NavDisableHighlight;
#endif
}

} // namespace forefront::imgui
