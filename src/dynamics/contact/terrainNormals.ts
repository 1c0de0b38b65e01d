import type { TerrainNormals } from '../constants/world';
import { writeGroundNormal } from './groundNormal';
import { readSlope } from './slope';

/** The ground's own normals (DYNAMICS, "The ground's own normal"). */
export const TERRAIN_NORMALS: TerrainNormals = Object.freeze({ readSlope, writeGroundNormal });
