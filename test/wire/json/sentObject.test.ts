import { expect, it } from 'vitest';
import { decodeFrameJson, decodeHelloJson, encodeFrameJson } from '../../../src/wire';
import { FRAME } from '../messages';

const sent = encodeFrameJson(FRAME);

it('refuses a socket’s event, and names the member that has its text', () => {
  const event = new MessageEvent('message', { data: JSON.stringify(sent) });
  for (const decode of [decodeFrameJson, decodeHelloJson])
    expect(decode(event)).toMatchObject({
      ok: false,
      reason: expect.stringMatching(/\.data holds/) as string,
    });
});

it('takes a message for what it is where the server adds a member called data', () => {
  expect(decodeFrameJson({ ...sent, data: 'anything' }).ok).toBe(true);
});
