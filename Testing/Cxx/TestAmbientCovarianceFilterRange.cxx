// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Without a range, pieces take that of the whole extent, asked for once in slabs, so that they are
// bit for bit the whole; also with another filter behind.

#include "FilterTesting.h"
#include "vtkAmbientCovarianceFilter.h"

int TestAmbientCovarianceFilterRange(int, char*[])
{
  testing::Report report;
  testing::Geometry geometry;
  const auto image = testing::MakeImage(
    geometry, [](const glm::dvec3& p) { return p.x * p.x + 3.0 * p.y + 10.0 * std::sin(p.z); });
  vtkNew<vtkAmbientCovarianceFilter> direct;
  direct->SetInputData(image);
  direct->SetRadius(3.0);
  direct->Update();
  vtkNew<testing::RecordingSource> source;
  source->SetImage(image);
  vtkNew<vtkAmbientCovarianceFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetRadius(3.0);
  long long different = 0;
  long long passes = 0;
  for (const auto& octant : testing::Octants(image->GetExtent()))
  {
    source->Requests.clear();
    filter->UpdateExtent(octant.data());
    different += testing::CountDifferent(direct->GetOutput(), filter->GetOutput(), "AmbientCovariance");
    passes += static_cast<long long>(source->Requests.size()) - 1;
    for (const auto& request : source->Requests)
    {
      report.Check(request != geometry.Extent, "no request is for the whole");
    }
  }
  report.CheckAtMost(different, 0, "voxels of pieces that differ from the whole");
  report.CheckAtLeast(passes, 2, "requests for the range");
  report.CheckAtMost(passes, 8, "requests for the range");

  vtkNew<vtkAmbientCovarianceFilter> middle;
  middle->SetInputConnection(source->GetOutputPort());
  middle->SetRadius(3.0);
  vtkNew<vtkAmbientCovarianceFilter> behind;
  behind->SetInputConnection(middle->GetOutputPort());
  behind->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "AmbientCovariance");
  behind->SetScalarRange(-1.0, 1.0);
  behind->SetRadius(1.0);
  int corner[6] = { 0, 7, 0, 7, 0, 7 };
  behind->UpdateExtent(corner);
  report.CheckAtMost(testing::CountDifferent(direct->GetOutput(), middle->GetOutput(), "AmbientCovariance"),
    0, "voxels of the filter in the middle that differ");
  report.Check(behind->GetOutput()->GetNumberOfPoints() == 512, "the filter behind has its piece");
  return report.ExitCode();
}
