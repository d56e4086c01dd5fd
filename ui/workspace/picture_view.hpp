#pragma once

namespace forefront {

struct Document;
struct Workspace;

/// Keeps the background picture where it is on the screen after its scale has changed since `before`, if the drawing
/// is empty: nothing else is in view that could stay in place.
void keepPictureInView(Workspace &context, const Document &before);

} // namespace forefront
