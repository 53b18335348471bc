// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GalleryStudio.h"

#include "GalleryField.h"
#include "LineStudio.h"
#include "VolumeScene.h"
#include "StructuralScore.h"
#include "TracedPicture.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace
{
namespace fs = std::filesystem;
using nlohmann::json;

const char* const KnownFile = "cache.json";

// FNV-1a, for names of files that depend on their settings.
std::string HashOf(const json& settings)
{
  std::uint64_t hash = 14695981039346656037ULL;
  for (const unsigned char byte : settings.dump())
  {
    hash = (hash ^ byte) * 1099511628211ULL;
  }
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

json KeyOf(const std::string& field, const PictureSettings& picture)
{
  return { { "field", field }, { "fieldVersion", GalleryFieldVersion }, { "picture", picture },
    { "program", VOLUMEOPTICS_VERSION } };
}

// The same picture by the phase function alone, which needs no frame.
PictureSettings ReferenceOf(PictureSettings picture)
{
  picture.Optics = OpticsSettings{};
  picture.Optics.Model = "none";
  picture.Ambient = AmbientSettings{};
  picture.Function.Specular = 0.0;
  return picture;
}
}

GalleryStudio::GalleryStudio(const std::string& folder, const std::string& cranium, bool headless, bool force)
  : Folder(folder)
  , CraniumFile(cranium)
  , Headless(headless)
  , Force(force)
{
  fs::create_directories(fs::path(folder) / "images");
  std::ifstream file(fs::path(folder) / KnownFile);
  this->Known = json::parse(file, nullptr, false);
  if (!this->Known.is_object())
  {
    this->Known = json::object();
  }
}

GalleryStudio::~GalleryStudio() = default;

PictureResult GalleryStudio::Draw(
  const std::string& name, const std::string& field, const PictureSettings& picture, Timing timing)
{
  const PictureSettings reference = ReferenceOf(picture);
  const std::string file = "images/" + name + ".png";
  const std::string referenceFile = "images/reference-" + HashOf(KeyOf(field, reference)) + ".png";
  PictureResult result = this->DrawOnly(file, field, picture, timing);
  if (result.Reference != referenceFile)
  {
    this->DrawOnly(referenceFile, field, reference, Untimed);
    result.Reference = referenceFile;
    result.Score = StructuralScore(this->Folder + "/" + file, this->Folder + "/" + referenceFile);
    this->Known[file]["result"] = result;
    this->Remember();
  }
  return result;
}

PictureResult GalleryStudio::DrawUnscored(
  const std::string& name, const std::string& field, const PictureSettings& picture)
{
  return this->DrawOnly("images/" + name + ".png", field, picture, Timed);
}

PictureResult GalleryStudio::Keep(const std::string& name)
{
  PictureResult result;
  result.File = "images/" + name + ".png";
  WriteTracedPicture(name, this->Folder + "/" + result.File);
  return result;
}

PictureResult GalleryStudio::DrawOnly(
  const std::string& file, const std::string& field, const PictureSettings& picture, Timing timing)
{
  const json key = KeyOf(field, picture);
  if (this->IsKnown(file, key))
  {
    return this->Known[file]["result"].get<PictureResult>();
  }
  VolumeScene& scene = this->Stage(field);
  scene.Apply(picture);
  PictureResult result;
  scene.Render();
  result.File = file;
  result.PreparationSeconds = scene.GetPreparationSeconds();
  result.FrameSeconds = timing == Timed ? scene.Render() : 0.0;
  scene.WritePng(this->Folder + "/" + file);
  this->Keep(file, key, result, scene.GetRendererName());
  return result;
}

bool GalleryStudio::IsKnown(const std::string& file, const json& key) const
{
  const auto known = this->Known.find(file);
  return known != this->Known.end() && (*known)["settings"] == key &&
    fs::exists(fs::path(this->Folder) / file) && (!this->Force || (*known).contains("thisRun"));
}

void GalleryStudio::Keep(
  const std::string& file, const json& key, const PictureResult& result, const std::string& renderer)
{
  this->Known["renderer"] = { { "name", renderer } };
  this->Known[file] = { { "settings", key }, { "result", result }, { "thisRun", true } };
  this->Remember();
  ++this->NumberOfPicturesDrawn;
}

PictureResult GalleryStudio::DrawLines(
  const std::string& name, const LinePicture& lines, const PictureSettings& picture)
{
  const std::string file = "images/" + name + ".png";
  const json key = { { "lines", lines }, { "picture", picture }, { "program", VOLUMEOPTICS_VERSION } };
  if (this->IsKnown(file, key))
  {
    return this->Known[file]["result"].get<PictureResult>();
  }
  this->Staged.reset();
  if (!this->Lines)
  {
    this->Lines = std::make_unique<LineStudio>(OffScreenWindow(this->Headless));
  }
  const LineStudio::Result drawn = this->Lines->Draw(lines, picture, this->Folder + "/" + file);
  PictureResult result;
  result.File = file;
  result.PreparationSeconds = drawn.VoxelSeconds;
  result.FrameSeconds = drawn.FrameSeconds;
  this->Keep(file, key, result, drawn.Renderer);
  return result;
}

VolumeScene& GalleryStudio::Stage(const std::string& field)
{
  if (!this->Staged || this->StagedField != field)
  {
    this->Staged.reset();
    this->Staged =
      std::make_unique<VolumeScene>(GalleryField(field, this->CraniumFile), OffScreenWindow(this->Headless));
    this->StagedField = field;
  }
  return *this->Staged;
}

std::string GalleryStudio::GetRendererName() const
{
  return this->Known.value("renderer", json::object()).value("name", "an unknown machine");
}

// After each picture, so that an interrupted run goes on where it stopped.
void GalleryStudio::Remember()
{
  json lasting = this->Known;
  for (auto& item : lasting)
  {
    item.erase("thisRun");
  }
  std::ofstream(fs::path(this->Folder) / KnownFile) << lasting.dump(1) << "\n";
}
