#include "ui/tools/make_tools.hpp"

#include "ui/tools/arc_tool.hpp"
#include "ui/tools/box_tool.hpp"
#include "ui/tools/brush_tool.hpp"
#include "ui/tools/gradient_tool.hpp"
#include "ui/tools/guess_tool.hpp"
#include "ui/tools/measure_tool.hpp"
#include "ui/tools/pen_tool.hpp"
#include "ui/tools/picture_tool.hpp"
#include "ui/tools/point_tool.hpp"
#include "ui/tools/probe_tool.hpp"
#include "ui/tools/region_tool.hpp"
#include "ui/tools/round_tools.hpp"
#include "ui/tools/select_tool.hpp"
#include "ui/tools/slot_tool.hpp"
#include "ui/tools/source_tool.hpp"
#include "ui/tools/trace_tool.hpp"
#include "ui/tools/trim_tool.hpp"

namespace forefront {

std::vector<std::unique_ptr<Tool>> makeTools() {
    const auto state = std::make_shared<EditState>();
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<SelectTool>(state));
    tools.push_back(std::make_unique<PenTool>(state, ShapeKind::Polygon));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Rectangle));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Circle));
    tools.push_back(std::make_unique<BoxTool>(state, ShapeKind::Ellipse));
    tools.push_back(std::make_unique<RegularPolygonTool>(state));
    tools.push_back(std::make_unique<SlotTool>(state));
    tools.push_back(std::make_unique<PenTool>(state, ShapeKind::Polyline));
    tools.push_back(std::make_unique<ArcTool>(state));
    tools.push_back(std::make_unique<PointTool>(state));
    tools.push_back(std::make_unique<TrimTool>(state));
    tools.push_back(std::make_unique<RegionTool>(state));
    tools.push_back(std::make_unique<BrushTool>(state, false));
    tools.push_back(std::make_unique<BrushTool>(state, true));
    tools.push_back(std::make_unique<SourceTool>(state));
    tools.push_back(std::make_unique<GradientTool>(state));
    tools.push_back(std::make_unique<MeasureTool>(state));
    tools.push_back(std::make_unique<PictureTool>(state));
    tools.push_back(std::make_unique<TraceTool>());
    tools.push_back(std::make_unique<ProbeTool>());
    tools.push_back(std::make_unique<GuessTool>());
    return tools;
}

} // namespace forefront
