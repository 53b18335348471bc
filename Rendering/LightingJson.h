// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// A lighting transfer function as JSON; the format is described in vtkLightingTransferFunction.h.

#ifndef LightingJson_h
#define LightingJson_h

#include "JsonDocument.h"
#include "LightingTable.h"

namespace volumeoptics
{
Json::Value LightingToJson(const LightingFunction& function);
LightingFunction LightingFromJson(const Json::Value& document); // throws JsonError
}

#endif
