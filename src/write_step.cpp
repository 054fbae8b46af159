// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bspline_surface.h>
#include <cgal_blend/mesh_io.h>

#ifdef CGAL_BLEND_HAS_STEP

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>

#include <filesystem>

namespace cgal_blend {

namespace {

/// Open CASCADE talks to standard output; the library does not.
class Silence {
 public:
  Silence() {
    printers_ = Message::DefaultMessenger()->Printers(), Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }

 private:
  Message_SequenceOfPrinters printers_;
};

opencascade::handle<Geom_BSplineSurface> geometry(const Bspline_surface& surface) {
  const int rows = static_cast<int>(surface.control.size()), columns = surface.degree_t + 1;
  const int knots = static_cast<int>(surface.knots.size());
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Point_3& p = surface.control[i][j];
      poles.SetValue(i + 1, j + 1, gp_Pnt(p.x(), p.y(), p.z()));
    }
  TColStd_Array1OfReal u(1, knots), v(1, 2);
  TColStd_Array1OfInteger u_multiplicities(1, knots), v_multiplicities(1, 2);
  for (int i = 0; i < knots; ++i) {
    u.SetValue(i + 1, surface.knots[i]);
    u_multiplicities.SetValue(i + 1, i == 0 || i == knots - 1 ? 4 : 2);
  }
  for (int i : {1, 2}) {
    v.SetValue(i, i - 1);
    v_multiplicities.SetValue(i, surface.degree_t + 1);
  }
  return new Geom_BSplineSurface(poles, u, v, u_multiplicities, v_multiplicities, 3, surface.degree_t);
}

bool write(const std::string& path, const std::vector<Bspline_surface>& surfaces) {
  const Silence silence;
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const Bspline_surface& surface : surfaces) {
    BRepBuilderAPI_MakeFace face(geometry(surface), Precision::Confusion());
    if (!face.IsDone()) return false;
    builder.Add(compound, face.Face());
  }
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  return writer.Transfer(compound, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(path.c_str()) == IFSelect_RetDone;
}

}  // namespace

bool has_step() noexcept { return true; }

void write_step(const std::string& path, const std::vector<Bspline_surface>& surfaces) {
  const std::string beside = path + ".part";
  bool written = false;
  try {
    written = write(beside, surfaces);
  } catch (const Standard_Failure&) {
  }
  std::error_code error;
  if (written) std::filesystem::rename(beside, path, error);
  if (written && !error) return;
  std::filesystem::remove(beside, error);
  throw Mesh_io_error(Mesh_io_error::Kind::unwritable, "cannot write \"" + path + "\"");
}

}  // namespace cgal_blend

#else

namespace cgal_blend {

bool has_step() noexcept { return false; }

void write_step(const std::string& path, const std::vector<Bspline_surface>&) {
  throw Mesh_io_error(
      Mesh_io_error::Kind::unknown_format,
      "cannot write \"" + path + "\": this program was built without Open CASCADE, which STEP files need");
}

}  // namespace cgal_blend

#endif
