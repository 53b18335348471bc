// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What any object of VTK says while this one lives, instead of the output, where it would fail the test.

#ifndef CapturedOutput_h
#define CapturedOutput_h

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace
{
class OutputOfTest : public vtkOutputWindow
{
public:
  static OutputOfTest* New();
  vtkTypeMacro(OutputOfTest, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Texts.emplace_back(text); }

  std::vector<std::string> Texts;

protected:
  OutputOfTest() = default;
  ~OutputOfTest() override = default;

private:
  OutputOfTest(const OutputOfTest&) = delete;
  void operator=(const OutputOfTest&) = delete;
};
vtkStandardNewMacro(OutputOfTest);

class CapturedOutput
{
public:
  CapturedOutput()
    : Before(vtkOutputWindow::GetInstance())
  {
    vtkOutputWindow::SetInstance(this->Window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~CapturedOutput()
  {
    vtkOutputWindow::SetInstance(this->Before);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO); // VTK's default
  }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  const std::vector<std::string>& GetTexts() const { return this->Window->Texts; }

private:
  vtkSmartPointer<vtkOutputWindow> Before;
  vtkNew<OutputOfTest> Window;
};
}

#endif
