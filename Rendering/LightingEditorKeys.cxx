// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The keys of the editor of lighting transfer functions.

#include "LightingEditor.h"

#include <algorithm>
#include <map>

namespace volumeoptics
{
namespace
{
// Shares of the range of scalars.
const double FineStep = 1.0 / 256.0;
const double CoarseStep = 1.0 / 32.0;
const double CoefficientStep = 0.05;
}

double LightingEditor::RangeWidth() const
{
  return this->Layout.Range[1] - this->Layout.Range[0];
}

void LightingEditor::ChangeSoftness(double steps)
{
  if (this->IsSelected())
  {
    this->History.Record(this->Function);
    const double softness =
      this->Function->GetSoftness(this->Selected) + steps * FineStep * this->RangeWidth();
    this->Function->SetSoftness(this->Selected, std::clamp(softness, 0.0, this->RangeWidth()));
  }
}

void LightingEditor::ChangeCoefficient(double change)
{
  this->History.Record(this->Function);
  LightingCoefficients k;
  this->Function->GetCoefficients(this->Selected, k.data());
  k[this->Coefficient] = std::clamp(k[this->Coefficient] + change, 0.0, 1.0);
  this->Function->SetCoefficients(this->Selected, k[0], k[1], k[2]);
}

void LightingEditor::Move(double scalars)
{
  if (this->IsMovable(this->Selected, this->Side))
  {
    this->History.Record(this->Function);
    this->RememberRanges(this->Selected);
    const std::array<double, 2>& range = this->StartRanges[this->Side];
    this->Function->SetRange(this->Selected, this->Side, range[0] + scalars, range[1] + scalars);
  }
}

void LightingEditor::Widen(double scalars)
{
  if (this->IsMovable(this->Selected, this->Side))
  {
    this->History.Record(this->Function);
    this->RememberRanges(this->Selected);
    const std::array<double, 2>& range = this->StartRanges[this->Side];
    const double change = std::max(scalars, 0.5 * (range[0] - range[1]));
    this->Function->SetRange(this->Selected, this->Side, range[0] - change, range[1] + change);
  }
}

bool LightingEditor::KeyOfSelected(const std::string& symbol, bool shift)
{
  const double step = (shift ? CoarseStep : FineStep) * this->RangeWidth();
  const std::map<std::string, void (*)(LightingEditor*, double)> keys = {
    { "Delete", [](LightingEditor* editor, double) { editor->RemoveSelected(); } },
    { "BackSpace", [](LightingEditor* editor, double) { editor->RemoveSelected(); } },
    { "Left", [](LightingEditor* editor, double length) { editor->Move(-length); } },
    { "Right", [](LightingEditor* editor, double length) { editor->Move(length); } },
    { "Up", [](LightingEditor* editor, double) { editor->ChangeCoefficient(CoefficientStep); } },
    { "Down", [](LightingEditor* editor, double) { editor->ChangeCoefficient(-CoefficientStep); } },
    { "bracketleft", [](LightingEditor* editor, double length) { editor->Widen(-length); } },
    { "bracketright", [](LightingEditor* editor, double length) { editor->Widen(length); } },
    { "braceleft", [](LightingEditor* editor, double length) { editor->Widen(-length); } },
    { "braceright", [](LightingEditor* editor, double length) { editor->Widen(length); } },
    { "plus", [](LightingEditor* editor, double) { editor->ChangeSoftness(1.0); } },
    { "minus", [](LightingEditor* editor, double) { editor->ChangeSoftness(-1.0); } },
    { "space", [](LightingEditor* editor, double) { editor->Side = 1 - editor->Side; } },
  };
  const auto key = keys.find(symbol);
  if (key == keys.end() || !this->IsSelected())
  {
    return false;
  }
  key->second(this, step);
  return true;
}

bool LightingEditor::KeyOfHistory(const std::string& symbol, bool redo)
{
  const bool isUndo = symbol == "z" || symbol == "Z";
  if (!isUndo && symbol != "y")
  {
    return false;
  }
  return isUndo && !redo ? this->Undo() : this->Redo();
}

bool LightingEditor::KeyOfAll(const std::string& symbol)
{
  if (symbol == "Escape")
  {
    this->Cancel();
    this->Selected = -1;
  }
  else if (symbol == "Tab")
  {
    const int count = this->Function->GetNumberOfBoundaries();
    this->Select(count > 0 ? (this->GetSelected() + 1) % count : -1);
  }
  else if (symbol == "c")
  {
    this->Coefficient = (this->Coefficient + 1) % 3;
  }
  else if (symbol == "a")
  {
    const double width = this->RangeWidth();
    this->AddAround(this->Layout.Range[0] + 0.75 * width, this->Layout.Range[0] + 0.25 * width);
  }
  else
  {
    return false;
  }
  return true;
}

bool LightingEditor::Key(const std::string& symbol, bool control, bool shift)
{
  return this->Function &&
    (this->KeyOfHistory(symbol, control && shift) || this->KeyOfAll(symbol) ||
      this->KeyOfSelected(symbol, shift));
}
}
