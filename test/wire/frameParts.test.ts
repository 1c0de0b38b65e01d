import { expect, it } from 'vitest';
import {
  decodeServerMessage,
  encodeCommonPart,
  encodeOwnPart,
  encodeShipPart,
  joinFrameParts,
  type ServerFrame,
} from '../../src/wire';
import { FRAME } from './messages';

const joined = (frame: ServerFrame) =>
  joinFrameParts([
    encodeCommonPart(FRAME),
    encodeOwnPart(frame.events, frame.lastInput),
    ...frame.ships.map(encodeShipPart),
  ]);

it('a frame joined from its parts is the frame', () => {
  expect(decodeServerMessage(joined(FRAME))).toEqual({ ok: true, value: FRAME });
  const bare = { ...FRAME, ships: [], events: [], lastInput: null };
  expect(decodeServerMessage(joined(bare))).toEqual({ ok: true, value: bare });
});

it('leaves the client’s own fields out of the common part', () => {
  const bare = { ...FRAME, ships: [], events: [], lastInput: null };
  expect(decodeServerMessage(joinFrameParts([encodeCommonPart(FRAME)]))).toEqual({ ok: true, value: bare });
});
