#include "tests/solids/made_parts.h"

#include <stdexcept>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

namespace g31::testing {

TopoDS_Shape block(const parts::Box& box) {
  return BRepPrimAPI_MakeBox(gp_Pnt(box.min.x(), box.min.y(), box.min.z()),
                             gp_Pnt(box.max.x(), box.max.y(), box.max.z()))
      .Shape();
}

TopoDS_Shape pin(const Point& foot, double diameter_mm, double height_mm) {
  const gp_Ax2 axes(gp_Pnt(foot.x(), foot.y(), foot.z()), gp_Dir(0.0, 0.0, 1.0));
  return BRepPrimAPI_MakeCylinder(axes, 0.5 * diameter_mm, height_mm).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& stock, const std::vector<TopoDS_Shape>& cuts) {
  TopTools_ListOfShape from;
  from.Append(stock);
  TopTools_ListOfShape tools;
  for (const TopoDS_Shape& tool : cuts) {
    tools.Append(tool);
  }
  BRepAlgoAPI_Cut cutting;
  cutting.SetArguments(from);
  cutting.SetTools(tools);
  cutting.Build();
  if (cutting.HasErrors()) {
    throw std::runtime_error("the shape is not cut");
  }
  ShapeUpgrade_UnifySameDomain unify(cutting.Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape inspection_product() {
  const TopoDS_Shape stock = block({{0, 0, -40}, {160, 110, 0}});
  return cut(stock, {
                        block({{0, 45, -10}, {160, 57, 0}}),
                        block({{20, 0, -12}, {36, 25, 0}}),
                        block({{60, 0, -8}, {72, 25, 0}}),
                        block({{90, 10, -15}, {130, 35, 0}}),
                        pin({30, 85, -18}, 20, 18),
                        pin({75, 85, -14}, 16, 14),
                        block({{120, 75, -12}, {160, 110, 0}}),
                    });
}

}  // namespace g31::testing
