// Thousands of lights that end at a distance: each fragment asks the list of its own part of the picture (a tile) and of the depth
// (a slice) which of them may reach it. The lists are made on the CPU: lighting/light_clusters.hpp.
// SPDX-License-Identifier: MIT
#if CLUSTERED

uniform highp usampler2D clusterBegins;  // a texel per cluster, 1024 a row: where its lights with k = 0, 1, 2 and others begin
uniform highp usampler2D clusterLights;  // numbers of point lights, 4096 a row
uniform ivec3 clusterGrid;               // columns, rows, slices
uniform vec4 clusterScale;               // tiles per pixel in x and y, slices per octave of depth, slice of depth 1

// The first list of this fragment's cluster; its four lists follow each other.
int cluster_list()
{
    float depth = log2(1.0 / gl_FragCoord.w) * clusterScale.z + clusterScale.w;
    ivec3 cell = clamp(ivec3(vec3(gl_FragCoord.xy * clusterScale.xy, depth)), ivec3(0), clusterGrid - 1);
    return 4 * ((cell.z * clusterGrid.y + cell.y) * clusterGrid.x + cell.x);
}

// Where a list begins in clusterLights; it ends where the next one begins.
int list_begin(int list)
{
    uvec4 begins = texelFetch(clusterBegins, ivec2(list / 4 % 1024, list / 4096), 0);
    int k = list % 4;
    return int(k == 0 ? begins.x : k == 1 ? begins.y : k == 2 ? begins.z : begins.w);
}

int listed_light(int j) { return int(texelFetch(clusterLights, ivec2(j % 4096, j / 4096), 0).x); }

#endif
