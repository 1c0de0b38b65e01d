import { DEFAULT_SETTINGS, loadSettings, type Settings } from '../../dynamics';
import type { galaxy } from '../generated/codec.js';
import { FINITE } from '../limits';
import { refuseLoaded } from '../loaders';
import { choiceIn, type Fields, numberIn, type Reading, valueIn } from './reading';

/** The server's contact settings (DYNAMICS, Settings); one that is not sent has the design's default. */
export function readSettings(r: Reading, from: Fields): Settings {
  const d = DEFAULT_SETTINGS;
  const sent = (name: string, absent: number) => numberIn(r, from, name, FINITE, absent);
  const settings: Settings = {
    contactCrashSpeed: sent('contact_crash_speed', d.contactCrashSpeed),
    contactBounceSpeed: sent('contact_bounce_speed', d.contactBounceSpeed),
    contactSettleTiltDeg: sent('contact_settle_tilt_deg', d.contactSettleTiltDeg),
    contactSettleAngularVel: sent('contact_settle_angular_vel', d.contactSettleAngularVel),
    contactSettleLinearVel: sent('contact_settle_linear_vel', d.contactSettleLinearVel),
    contactTippedAngleDeg: sent('contact_tipped_angle_deg', d.contactTippedAngleDeg),
    contactDampingRatio: sent('contact_damping_ratio', d.contactDampingRatio),
    contactFrictionStatic: sent('contact_friction_static', d.contactFrictionStatic),
    contactFrictionKinetic: sent('contact_friction_kinetic', d.contactFrictionKinetic),
    touchdownAttitude:
      valueIn(r, from, 'touchdown_attitude') === undefined
        ? d.touchdownAttitude
        : choiceIn(r, from, 'touchdown_attitude', ['aligned', 'kept'], false),
    surfaceNormal:
      valueIn(r, from, 'surface_normal') === undefined
        ? d.surfaceNormal
        : choiceIn(r, from, 'surface_normal', ['radial', 'terrain'], false),
    contactLongestSubstep: sent('contact_longest_substep', d.contactLongestSubstep),
  };
  refuseLoaded(r, loadSettings(settings), '');
  return settings;
}

export function settingsFields(s: Settings): galaxy.stream.Settings.$Properties {
  return {
    contact_crash_speed: s.contactCrashSpeed,
    contact_bounce_speed: s.contactBounceSpeed,
    contact_settle_tilt_deg: s.contactSettleTiltDeg,
    contact_settle_angular_vel: s.contactSettleAngularVel,
    contact_settle_linear_vel: s.contactSettleLinearVel,
    contact_tipped_angle_deg: s.contactTippedAngleDeg,
    contact_damping_ratio: s.contactDampingRatio,
    contact_friction_static: s.contactFrictionStatic,
    contact_friction_kinetic: s.contactFrictionKinetic,
    touchdown_attitude: s.touchdownAttitude,
    surface_normal: s.surfaceNormal,
    contact_longest_substep: s.contactLongestSubstep,
  };
}
