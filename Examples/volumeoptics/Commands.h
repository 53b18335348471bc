// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The subcommands of volumeoptics. Each adds its options to the program and returns through exceptions.

#ifndef Commands_h
#define Commands_h

#include <CLI/CLI.hpp>

void AddRenderCommand(CLI::App& program);
void AddLinesCommand(CLI::App& program);
void AddViewCommand(CLI::App& program);
void AddEditorCommand(CLI::App& program);
void AddInfoCommand(CLI::App& program);
void AddGalleryCommand(CLI::App& program);
void AddTradeCommand(CLI::App& program);

#endif
