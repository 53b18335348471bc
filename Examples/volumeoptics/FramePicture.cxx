// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FramePicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cmath>

FramePicture Reduced(const FramePicture& picture, int factor)
{
  FramePicture small{ picture.Width / factor, picture.Height / factor, {} };
  small.Values.assign(3 * small.Width * small.Height, 0.0);
  for (int y = 0; y < small.Height * factor; ++y)
  {
    for (int x = 0; x < small.Width * factor; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        small.Values[3 * (y / factor * small.Width + x / factor) + c] +=
          picture.Values[3 * (y * picture.Width + x) + c] / (factor * factor);
      }
    }
  }
  return small;
}

FramePicture ToFramePicture(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  FramePicture picture{ size[0], size[1], {} };
  const int components = image->GetNumberOfScalarComponents();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    picture.Values.insert(picture.Values.end(), bytes + i * components, bytes + i * components + 3);
  }
  return picture;
}

double SignalToNoise(const FramePicture& a, const FramePicture& b)
{
  double sum = 0.0;
  long long count = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 3)
  {
    double square = 0.0, most = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      square += std::pow(a.Values[i + c] - b.Values[i + c], 2.0);
      most = std::max(most, std::max(a.Values[i + c], b.Values[i + c]));
    }
    sum += most >= 0.5 ? square : 0.0;
    count += most >= 0.5 ? 3 : 0;
  }
  return sum > 0.0 ? 10.0 * std::log10(255.0 * 255.0 * count / sum) : 99.0;
}

void WritePng(const FramePicture& picture, const std::string& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::transform(picture.Values.begin(), picture.Values.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()),
    [](double value) { return static_cast<unsigned char>(std::lround(value)); });
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}
