// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What of the scalars a scene shows.

#ifndef VisibleInScene_h
#define VisibleInScene_h

#include "OpticsScene.h"
#include "VisibleScalars.h"

/** Whether what is seen follows from the scalars that a ray meets. */
bool IsSeenByScalars(const OpticsScene& scene);

/** What may be seen of all scalars that a ray meets; before VTK has loaded the volume, too. */
VisibleScalars FindVisibleScalars(const OpticsScene& scene);

/** The same where they are all alike: in data space only isosurfaces. */
VisibleScalars FindVisibleWhereConstant(const OpticsScene& scene);

#endif
