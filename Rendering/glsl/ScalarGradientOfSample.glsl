// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

  // Place Optics::Gradient. Once a sample: whoever lights it shares the fetches.
  g_opticsScalarGradient = opticsScalarGradient(g_dataPos);
