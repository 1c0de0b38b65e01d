/*eslint-disable block-scoped-var, id-length, no-control-regex, no-magic-numbers, no-mixed-operators, no-prototype-builtins, no-redeclare, no-shadow, no-var, sort-vars, default-case, jsdoc/require-param*/
import $protobuf from "protobufjs/minimal.js";

// Common aliases
const $Reader = $protobuf.Reader, $Writer = $protobuf.Writer, $util = $protobuf.util;
const $Object = $util.global.Object, $undefined = $util.global.undefined, $Error = $util.global.Error, $RangeError = $util.global.RangeError;

// Exported root namespace
const $root = $protobuf.roots["touchdown"] || ($protobuf.roots["touchdown"] = {});

export const galaxy = $root.galaxy = (() => {

    /**
     * Namespace galaxy.
     * @exports galaxy
     * @namespace
     */
    const galaxy = {};

    galaxy.stream = (function() {

        /**
         * Namespace stream.
         * @memberof galaxy
         * @namespace
         */
        const stream = {};

        stream.ServerMessage = (function() {

            /**
             * Properties of a ServerMessage.
             * @typedef {Object} galaxy.stream.ServerMessage.$Properties
             * @property {galaxy.stream.Hello.$Properties|null} [hello] ServerMessage hello
             * @property {galaxy.stream.ServerFrame.$Properties|null} [frame] ServerMessage frame
             * @property {galaxy.stream.Pong.$Properties|null} [pong] ServerMessage pong
             * @property {"hello"|"frame"|"pong"} [message] ServerMessage message
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ServerMessage.
             * @memberof galaxy.stream
             * @interface IServerMessage
             * @augments galaxy.stream.ServerMessage.$Properties
             * @deprecated Use galaxy.stream.ServerMessage.$Properties instead.
             */

            /**
             * Narrowed shape of a ServerMessage.
             * @typedef {{
             *   hello?: galaxy.stream.Hello.$Shape|null;
             *   frame?: galaxy.stream.ServerFrame.$Shape|null;
             *   pong?: galaxy.stream.Pong.$Shape|null;
             *   $unknowns?: Array.<Uint8Array>;
             * } & (
             *   ({ message?: undefined; hello?: null; frame?: null; pong?: null }|{ message?: "hello"; hello: galaxy.stream.Hello.$Shape; frame?: null; pong?: null }|{ message?: "frame"; hello?: null; frame: galaxy.stream.ServerFrame.$Shape; pong?: null }|{ message?: "pong"; hello?: null; frame?: null; pong: galaxy.stream.Pong.$Shape })
             * )} galaxy.stream.ServerMessage.$Shape
             */

            /**
             * Constructs a new ServerMessage.
             * @memberof galaxy.stream
             * @classdesc Represents a ServerMessage.
             * @constructor
             * @param {galaxy.stream.ServerMessage.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ServerMessage = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ServerMessage hello.
             * @member {galaxy.stream.Hello.$Properties|null|undefined} hello
             * @memberof galaxy.stream.ServerMessage
             * @instance
             */
            ServerMessage.prototype.hello = null;

            /**
             * ServerMessage frame.
             * @member {galaxy.stream.ServerFrame.$Properties|null|undefined} frame
             * @memberof galaxy.stream.ServerMessage
             * @instance
             */
            ServerMessage.prototype.frame = null;

            /**
             * ServerMessage pong.
             * @member {galaxy.stream.Pong.$Properties|null|undefined} pong
             * @memberof galaxy.stream.ServerMessage
             * @instance
             */
            ServerMessage.prototype.pong = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            /**
             * ServerMessage message.
             * @member {"hello"|"frame"|"pong"|undefined} message
             * @memberof galaxy.stream.ServerMessage
             * @instance
             */
            $Object.defineProperty(ServerMessage.prototype, "message", {
                get: $util.oneOfGetter($oneOfFields = ["hello", "frame", "pong"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified ServerMessage message. Does not implicitly {@link galaxy.stream.ServerMessage.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.ServerMessage
             * @static
             * @param {galaxy.stream.ServerMessage.$Properties} message ServerMessage message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ServerMessage.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.hello != null && $Object.hasOwnProperty.call(message, "hello"))
                    $root.galaxy.stream.Hello.encode(message.hello, writer.uint32(/* id 1, wireType 2 =*/10).fork(), _depth + 1).ldelim();
                if (message.frame != null && $Object.hasOwnProperty.call(message, "frame"))
                    $root.galaxy.stream.ServerFrame.encode(message.frame, writer.uint32(/* id 2, wireType 2 =*/18).fork(), _depth + 1).ldelim();
                if (message.pong != null && $Object.hasOwnProperty.call(message, "pong"))
                    $root.galaxy.stream.Pong.encode(message.pong, writer.uint32(/* id 3, wireType 2 =*/26).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ServerMessage message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.ServerMessage
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.ServerMessage & galaxy.stream.ServerMessage.$Shape} ServerMessage
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ServerMessage.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.ServerMessage();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            message.hello = $root.galaxy.stream.Hello.decode(reader, reader.size(), $undefined, _depth + 1, message.hello);
                            message.message = "hello";
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            message.frame = $root.galaxy.stream.ServerFrame.decode(reader, reader.size(), $undefined, _depth + 1, message.frame);
                            message.message = "frame";
                            continue;
                        }
                    case 3: {
                            if (wireType !== 2)
                                break;
                            message.pong = $root.galaxy.stream.Pong.decode(reader, reader.size(), $undefined, _depth + 1, message.pong);
                            message.message = "pong";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ServerMessage;
        })();

        stream.ClientMessage = (function() {

            /**
             * Properties of a ClientMessage.
             * @typedef {Object} galaxy.stream.ClientMessage.$Properties
             * @property {galaxy.stream.ClientFrame.$Properties|null} [inputs] ClientMessage inputs
             * @property {galaxy.stream.Ping.$Properties|null} [ping] ClientMessage ping
             * @property {"inputs"|"ping"} [message] ClientMessage message
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ClientMessage.
             * @memberof galaxy.stream
             * @interface IClientMessage
             * @augments galaxy.stream.ClientMessage.$Properties
             * @deprecated Use galaxy.stream.ClientMessage.$Properties instead.
             */

            /**
             * Narrowed shape of a ClientMessage.
             * @typedef {{
             *   inputs?: galaxy.stream.ClientFrame.$Shape|null;
             *   ping?: galaxy.stream.Ping.$Shape|null;
             *   $unknowns?: Array.<Uint8Array>;
             * } & (
             *   ({ message?: undefined; inputs?: null; ping?: null }|{ message?: "inputs"; inputs: galaxy.stream.ClientFrame.$Shape; ping?: null }|{ message?: "ping"; inputs?: null; ping: galaxy.stream.Ping.$Shape })
             * )} galaxy.stream.ClientMessage.$Shape
             */

            /**
             * Constructs a new ClientMessage.
             * @memberof galaxy.stream
             * @classdesc Represents a ClientMessage.
             * @constructor
             * @param {galaxy.stream.ClientMessage.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ClientMessage = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ClientMessage inputs.
             * @member {galaxy.stream.ClientFrame.$Properties|null|undefined} inputs
             * @memberof galaxy.stream.ClientMessage
             * @instance
             */
            ClientMessage.prototype.inputs = null;

            /**
             * ClientMessage ping.
             * @member {galaxy.stream.Ping.$Properties|null|undefined} ping
             * @memberof galaxy.stream.ClientMessage
             * @instance
             */
            ClientMessage.prototype.ping = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            /**
             * ClientMessage message.
             * @member {"inputs"|"ping"|undefined} message
             * @memberof galaxy.stream.ClientMessage
             * @instance
             */
            $Object.defineProperty(ClientMessage.prototype, "message", {
                get: $util.oneOfGetter($oneOfFields = ["inputs", "ping"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified ClientMessage message. Does not implicitly {@link galaxy.stream.ClientMessage.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.ClientMessage
             * @static
             * @param {galaxy.stream.ClientMessage.$Properties} message ClientMessage message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ClientMessage.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.inputs != null && $Object.hasOwnProperty.call(message, "inputs"))
                    $root.galaxy.stream.ClientFrame.encode(message.inputs, writer.uint32(/* id 1, wireType 2 =*/10).fork(), _depth + 1).ldelim();
                if (message.ping != null && $Object.hasOwnProperty.call(message, "ping"))
                    $root.galaxy.stream.Ping.encode(message.ping, writer.uint32(/* id 2, wireType 2 =*/18).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ClientMessage message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.ClientMessage
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.ClientMessage & galaxy.stream.ClientMessage.$Shape} ClientMessage
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ClientMessage.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.ClientMessage();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            message.inputs = $root.galaxy.stream.ClientFrame.decode(reader, reader.size(), $undefined, _depth + 1, message.inputs);
                            message.message = "inputs";
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            message.ping = $root.galaxy.stream.Ping.decode(reader, reader.size(), $undefined, _depth + 1, message.ping);
                            message.message = "ping";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ClientMessage;
        })();

        stream.Hello = (function() {

            /**
             * Properties of a Hello.
             * @typedef {Object} galaxy.stream.Hello.$Properties
             * @property {string|null} [player_id] Hello player_id
             * @property {string|null} [ship_id] Hello ship_id
             * @property {galaxy.stream.Settings.$Properties|null} [settings] Hello settings
             * @property {Array.<galaxy.stream.ShipClass.$Properties>|null} [ship_classes] Hello ship_classes
             * @property {Array.<galaxy.physics.BodyState.$Properties>|null} [bodies] Hello bodies
             * @property {string|null} [terrain] Hello terrain
             * @property {number|Long|null} [tick] Hello tick
             * @property {number|null} [tick_rate] Hello tick_rate
             * @property {number|null} [time_scale] Hello time_scale
             * @property {string|null} [input_granularity] Hello input_granularity
             * @property {string|null} [protocol_version] Hello protocol_version
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a Hello.
             * @memberof galaxy.stream
             * @interface IHello
             * @augments galaxy.stream.Hello.$Properties
             * @deprecated Use galaxy.stream.Hello.$Properties instead.
             */

            /**
             * Shape of a Hello.
             * @typedef {galaxy.stream.Hello.$Properties} galaxy.stream.Hello.$Shape
             */

            /**
             * Constructs a new Hello.
             * @memberof galaxy.stream
             * @classdesc Represents a Hello.
             * @constructor
             * @param {galaxy.stream.Hello.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Hello = function (properties) {
                this.ship_classes = [];
                this.bodies = [];
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Hello player_id.
             * @member {string} player_id
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.player_id = "";

            /**
             * Hello ship_id.
             * @member {string} ship_id
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.ship_id = "";

            /**
             * Hello settings.
             * @member {galaxy.stream.Settings.$Properties|null|undefined} settings
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.settings = null;

            /**
             * Hello ship_classes.
             * @member {Array.<galaxy.stream.ShipClass.$Properties>} ship_classes
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.ship_classes = $util.emptyArray;

            /**
             * Hello bodies.
             * @member {Array.<galaxy.physics.BodyState.$Properties>} bodies
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.bodies = $util.emptyArray;

            /**
             * Hello terrain.
             * @member {string} terrain
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.terrain = "";

            /**
             * Hello tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Hello tick_rate.
             * @member {number} tick_rate
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.tick_rate = 0;

            /**
             * Hello time_scale.
             * @member {number} time_scale
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.time_scale = 0;

            /**
             * Hello input_granularity.
             * @member {string} input_granularity
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.input_granularity = "";

            /**
             * Hello protocol_version.
             * @member {string} protocol_version
             * @memberof galaxy.stream.Hello
             * @instance
             */
            Hello.prototype.protocol_version = "";

            /**
             * Encodes the specified Hello message. Does not implicitly {@link galaxy.stream.Hello.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Hello
             * @static
             * @param {galaxy.stream.Hello.$Properties} message Hello message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Hello.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.player_id != null && $Object.hasOwnProperty.call(message, "player_id") && message.player_id !== "")
                    writer.uint32(/* id 1, wireType 2 =*/10).string(message.player_id);
                if (message.ship_id != null && $Object.hasOwnProperty.call(message, "ship_id") && message.ship_id !== "")
                    writer.uint32(/* id 2, wireType 2 =*/18).string(message.ship_id);
                if (message.settings != null && $Object.hasOwnProperty.call(message, "settings"))
                    $root.galaxy.stream.Settings.encode(message.settings, writer.uint32(/* id 3, wireType 2 =*/26).fork(), _depth + 1).ldelim();
                if (message.ship_classes != null && message.ship_classes.length)
                    for (let i = 0; i < message.ship_classes.length; ++i)
                        $root.galaxy.stream.ShipClass.encode(message.ship_classes[i], writer.uint32(/* id 4, wireType 2 =*/34).fork(), _depth + 1).ldelim();
                if (message.bodies != null && message.bodies.length)
                    for (let i = 0; i < message.bodies.length; ++i)
                        $root.galaxy.physics.BodyState.encode(message.bodies[i], writer.uint32(/* id 5, wireType 2 =*/42).fork(), _depth + 1).ldelim();
                if (message.terrain != null && $Object.hasOwnProperty.call(message, "terrain") && message.terrain !== "")
                    writer.uint32(/* id 6, wireType 2 =*/50).string(message.terrain);
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 7, wireType 0 =*/56).uint64(message.tick);
                if (message.tick_rate != null && $Object.hasOwnProperty.call(message, "tick_rate") && !$Object.is(message.tick_rate, 0))
                    writer.uint32(/* id 8, wireType 1 =*/65).double(message.tick_rate);
                if (message.time_scale != null && $Object.hasOwnProperty.call(message, "time_scale") && !$Object.is(message.time_scale, 0))
                    writer.uint32(/* id 9, wireType 1 =*/73).double(message.time_scale);
                if (message.input_granularity != null && $Object.hasOwnProperty.call(message, "input_granularity") && message.input_granularity !== "")
                    writer.uint32(/* id 10, wireType 2 =*/82).string(message.input_granularity);
                if (message.protocol_version != null && $Object.hasOwnProperty.call(message, "protocol_version") && message.protocol_version !== "")
                    writer.uint32(/* id 11, wireType 2 =*/90).string(message.protocol_version);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a Hello message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Hello
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Hello & galaxy.stream.Hello.$Shape} Hello
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Hello.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Hello();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.player_id = value;
                            else
                                delete message.player_id;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.ship_id = value;
                            else
                                delete message.ship_id;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 2)
                                break;
                            message.settings = $root.galaxy.stream.Settings.decode(reader, reader.size(), $undefined, _depth + 1, message.settings);
                            continue;
                        }
                    case 4: {
                            if (wireType !== 2)
                                break;
                            if (!(message.ship_classes && message.ship_classes.length))
                                message.ship_classes = [];
                            message.ship_classes.push($root.galaxy.stream.ShipClass.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    case 5: {
                            if (wireType !== 2)
                                break;
                            if (!(message.bodies && message.bodies.length))
                                message.bodies = [];
                            message.bodies.push($root.galaxy.physics.BodyState.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.terrain = value;
                            else
                                delete message.terrain;
                            continue;
                        }
                    case 7: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 8: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.tick_rate = value;
                            else
                                delete message.tick_rate;
                            continue;
                        }
                    case 9: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.time_scale = value;
                            else
                                delete message.time_scale;
                            continue;
                        }
                    case 10: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.input_granularity = value;
                            else
                                delete message.input_granularity;
                            continue;
                        }
                    case 11: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.protocol_version = value;
                            else
                                delete message.protocol_version;
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Hello;
        })();

        stream.Settings = (function() {

            /**
             * Properties of a Settings.
             * @typedef {Object} galaxy.stream.Settings.$Properties
             * @property {number|null} [contact_crash_speed] Settings contact_crash_speed
             * @property {number|null} [contact_bounce_speed] Settings contact_bounce_speed
             * @property {number|null} [contact_settle_tilt_deg] Settings contact_settle_tilt_deg
             * @property {number|null} [contact_settle_angular_vel] Settings contact_settle_angular_vel
             * @property {number|null} [contact_settle_linear_vel] Settings contact_settle_linear_vel
             * @property {number|null} [contact_tipped_angle_deg] Settings contact_tipped_angle_deg
             * @property {number|null} [contact_damping_ratio] Settings contact_damping_ratio
             * @property {number|null} [contact_friction_static] Settings contact_friction_static
             * @property {number|null} [contact_friction_kinetic] Settings contact_friction_kinetic
             * @property {string|null} [touchdown_attitude] Settings touchdown_attitude
             * @property {string|null} [surface_normal] Settings surface_normal
             * @property {number|null} [contact_longest_substep] Settings contact_longest_substep
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a Settings.
             * @memberof galaxy.stream
             * @interface ISettings
             * @augments galaxy.stream.Settings.$Properties
             * @deprecated Use galaxy.stream.Settings.$Properties instead.
             */

            /**
             * Shape of a Settings.
             * @typedef {galaxy.stream.Settings.$Properties} galaxy.stream.Settings.$Shape
             */

            /**
             * Constructs a new Settings.
             * @memberof galaxy.stream
             * @classdesc Represents a Settings.
             * @constructor
             * @param {galaxy.stream.Settings.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Settings = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Settings contact_crash_speed.
             * @member {number|null|undefined} contact_crash_speed
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_crash_speed = null;

            /**
             * Settings contact_bounce_speed.
             * @member {number|null|undefined} contact_bounce_speed
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_bounce_speed = null;

            /**
             * Settings contact_settle_tilt_deg.
             * @member {number|null|undefined} contact_settle_tilt_deg
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_settle_tilt_deg = null;

            /**
             * Settings contact_settle_angular_vel.
             * @member {number|null|undefined} contact_settle_angular_vel
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_settle_angular_vel = null;

            /**
             * Settings contact_settle_linear_vel.
             * @member {number|null|undefined} contact_settle_linear_vel
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_settle_linear_vel = null;

            /**
             * Settings contact_tipped_angle_deg.
             * @member {number|null|undefined} contact_tipped_angle_deg
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_tipped_angle_deg = null;

            /**
             * Settings contact_damping_ratio.
             * @member {number|null|undefined} contact_damping_ratio
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_damping_ratio = null;

            /**
             * Settings contact_friction_static.
             * @member {number|null|undefined} contact_friction_static
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_friction_static = null;

            /**
             * Settings contact_friction_kinetic.
             * @member {number|null|undefined} contact_friction_kinetic
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_friction_kinetic = null;

            /**
             * Settings touchdown_attitude.
             * @member {string|null|undefined} touchdown_attitude
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.touchdown_attitude = null;

            /**
             * Settings surface_normal.
             * @member {string|null|undefined} surface_normal
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.surface_normal = null;

            /**
             * Settings contact_longest_substep.
             * @member {number|null|undefined} contact_longest_substep
             * @memberof galaxy.stream.Settings
             * @instance
             */
            Settings.prototype.contact_longest_substep = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_crash_speed", {
                get: $util.oneOfGetter($oneOfFields = ["contact_crash_speed"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_bounce_speed", {
                get: $util.oneOfGetter($oneOfFields = ["contact_bounce_speed"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_settle_tilt_deg", {
                get: $util.oneOfGetter($oneOfFields = ["contact_settle_tilt_deg"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_settle_angular_vel", {
                get: $util.oneOfGetter($oneOfFields = ["contact_settle_angular_vel"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_settle_linear_vel", {
                get: $util.oneOfGetter($oneOfFields = ["contact_settle_linear_vel"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_tipped_angle_deg", {
                get: $util.oneOfGetter($oneOfFields = ["contact_tipped_angle_deg"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_damping_ratio", {
                get: $util.oneOfGetter($oneOfFields = ["contact_damping_ratio"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_friction_static", {
                get: $util.oneOfGetter($oneOfFields = ["contact_friction_static"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_friction_kinetic", {
                get: $util.oneOfGetter($oneOfFields = ["contact_friction_kinetic"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_touchdown_attitude", {
                get: $util.oneOfGetter($oneOfFields = ["touchdown_attitude"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_surface_normal", {
                get: $util.oneOfGetter($oneOfFields = ["surface_normal"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Settings.prototype, "_contact_longest_substep", {
                get: $util.oneOfGetter($oneOfFields = ["contact_longest_substep"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified Settings message. Does not implicitly {@link galaxy.stream.Settings.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Settings
             * @static
             * @param {galaxy.stream.Settings.$Properties} message Settings message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Settings.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.contact_crash_speed != null && $Object.hasOwnProperty.call(message, "contact_crash_speed"))
                    writer.uint32(/* id 1, wireType 1 =*/9).double(message.contact_crash_speed);
                if (message.contact_bounce_speed != null && $Object.hasOwnProperty.call(message, "contact_bounce_speed"))
                    writer.uint32(/* id 2, wireType 1 =*/17).double(message.contact_bounce_speed);
                if (message.contact_settle_tilt_deg != null && $Object.hasOwnProperty.call(message, "contact_settle_tilt_deg"))
                    writer.uint32(/* id 3, wireType 1 =*/25).double(message.contact_settle_tilt_deg);
                if (message.contact_settle_angular_vel != null && $Object.hasOwnProperty.call(message, "contact_settle_angular_vel"))
                    writer.uint32(/* id 4, wireType 1 =*/33).double(message.contact_settle_angular_vel);
                if (message.contact_settle_linear_vel != null && $Object.hasOwnProperty.call(message, "contact_settle_linear_vel"))
                    writer.uint32(/* id 5, wireType 1 =*/41).double(message.contact_settle_linear_vel);
                if (message.contact_tipped_angle_deg != null && $Object.hasOwnProperty.call(message, "contact_tipped_angle_deg"))
                    writer.uint32(/* id 6, wireType 1 =*/49).double(message.contact_tipped_angle_deg);
                if (message.contact_damping_ratio != null && $Object.hasOwnProperty.call(message, "contact_damping_ratio"))
                    writer.uint32(/* id 7, wireType 1 =*/57).double(message.contact_damping_ratio);
                if (message.contact_friction_static != null && $Object.hasOwnProperty.call(message, "contact_friction_static"))
                    writer.uint32(/* id 8, wireType 1 =*/65).double(message.contact_friction_static);
                if (message.contact_friction_kinetic != null && $Object.hasOwnProperty.call(message, "contact_friction_kinetic"))
                    writer.uint32(/* id 9, wireType 1 =*/73).double(message.contact_friction_kinetic);
                if (message.touchdown_attitude != null && $Object.hasOwnProperty.call(message, "touchdown_attitude"))
                    writer.uint32(/* id 10, wireType 2 =*/82).string(message.touchdown_attitude);
                if (message.surface_normal != null && $Object.hasOwnProperty.call(message, "surface_normal"))
                    writer.uint32(/* id 11, wireType 2 =*/90).string(message.surface_normal);
                if (message.contact_longest_substep != null && $Object.hasOwnProperty.call(message, "contact_longest_substep"))
                    writer.uint32(/* id 12, wireType 1 =*/97).double(message.contact_longest_substep);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a Settings message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Settings
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Settings & galaxy.stream.Settings.$Shape} Settings
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Settings.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Settings();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 1)
                                break;
                            message.contact_crash_speed = reader.double();
                            message._contact_crash_speed = "contact_crash_speed";
                            continue;
                        }
                    case 2: {
                            if (wireType !== 1)
                                break;
                            message.contact_bounce_speed = reader.double();
                            message._contact_bounce_speed = "contact_bounce_speed";
                            continue;
                        }
                    case 3: {
                            if (wireType !== 1)
                                break;
                            message.contact_settle_tilt_deg = reader.double();
                            message._contact_settle_tilt_deg = "contact_settle_tilt_deg";
                            continue;
                        }
                    case 4: {
                            if (wireType !== 1)
                                break;
                            message.contact_settle_angular_vel = reader.double();
                            message._contact_settle_angular_vel = "contact_settle_angular_vel";
                            continue;
                        }
                    case 5: {
                            if (wireType !== 1)
                                break;
                            message.contact_settle_linear_vel = reader.double();
                            message._contact_settle_linear_vel = "contact_settle_linear_vel";
                            continue;
                        }
                    case 6: {
                            if (wireType !== 1)
                                break;
                            message.contact_tipped_angle_deg = reader.double();
                            message._contact_tipped_angle_deg = "contact_tipped_angle_deg";
                            continue;
                        }
                    case 7: {
                            if (wireType !== 1)
                                break;
                            message.contact_damping_ratio = reader.double();
                            message._contact_damping_ratio = "contact_damping_ratio";
                            continue;
                        }
                    case 8: {
                            if (wireType !== 1)
                                break;
                            message.contact_friction_static = reader.double();
                            message._contact_friction_static = "contact_friction_static";
                            continue;
                        }
                    case 9: {
                            if (wireType !== 1)
                                break;
                            message.contact_friction_kinetic = reader.double();
                            message._contact_friction_kinetic = "contact_friction_kinetic";
                            continue;
                        }
                    case 10: {
                            if (wireType !== 2)
                                break;
                            message.touchdown_attitude = reader.stringVerify();
                            message._touchdown_attitude = "touchdown_attitude";
                            continue;
                        }
                    case 11: {
                            if (wireType !== 2)
                                break;
                            message.surface_normal = reader.stringVerify();
                            message._surface_normal = "surface_normal";
                            continue;
                        }
                    case 12: {
                            if (wireType !== 1)
                                break;
                            message.contact_longest_substep = reader.double();
                            message._contact_longest_substep = "contact_longest_substep";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Settings;
        })();

        stream.ShipClass = (function() {

            /**
             * Properties of a ShipClass.
             * @typedef {Object} galaxy.stream.ShipClass.$Properties
             * @property {string|null} [name] ShipClass name
             * @property {number|null} [dry_mass] ShipClass dry_mass
             * @property {number|null} [fuel_capacity] ShipClass fuel_capacity
             * @property {galaxy.stream.InertiaTensor.$Properties|null} [inertia_tensor] ShipClass inertia_tensor
             * @property {number|null} [ground_contact_offset] ShipClass ground_contact_offset
             * @property {number|null} [leg_radius] ShipClass leg_radius
             * @property {number|null} [main_engine_thrust] ShipClass main_engine_thrust
             * @property {number|null} [main_engine_isp] ShipClass main_engine_isp
             * @property {galaxy.Vec3.$Properties|null} [rcs_thrust] ShipClass rcs_thrust
             * @property {galaxy.Vec3.$Properties|null} [rcs_torque] ShipClass rcs_torque
             * @property {number|null} [rcs_lever] ShipClass rcs_lever
             * @property {number|null} [rcs_isp] ShipClass rcs_isp
             * @property {galaxy.Vec3.$Properties|null} [reaction_wheel_torque] ShipClass reaction_wheel_torque
             * @property {galaxy.Vec3.$Properties|null} [reaction_wheel_capacity] ShipClass reaction_wheel_capacity
             * @property {number|null} [attitude_natural_frequency] ShipClass attitude_natural_frequency
             * @property {number|null} [dry_inertia_ratio] ShipClass dry_inertia_ratio
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ShipClass.
             * @memberof galaxy.stream
             * @interface IShipClass
             * @augments galaxy.stream.ShipClass.$Properties
             * @deprecated Use galaxy.stream.ShipClass.$Properties instead.
             */

            /**
             * Shape of a ShipClass.
             * @typedef {galaxy.stream.ShipClass.$Properties} galaxy.stream.ShipClass.$Shape
             */

            /**
             * Constructs a new ShipClass.
             * @memberof galaxy.stream
             * @classdesc Represents a ShipClass.
             * @constructor
             * @param {galaxy.stream.ShipClass.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ShipClass = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ShipClass name.
             * @member {string} name
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.name = "";

            /**
             * ShipClass dry_mass.
             * @member {number} dry_mass
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.dry_mass = 0;

            /**
             * ShipClass fuel_capacity.
             * @member {number} fuel_capacity
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.fuel_capacity = 0;

            /**
             * ShipClass inertia_tensor.
             * @member {galaxy.stream.InertiaTensor.$Properties|null|undefined} inertia_tensor
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.inertia_tensor = null;

            /**
             * ShipClass ground_contact_offset.
             * @member {number} ground_contact_offset
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.ground_contact_offset = 0;

            /**
             * ShipClass leg_radius.
             * @member {number} leg_radius
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.leg_radius = 0;

            /**
             * ShipClass main_engine_thrust.
             * @member {number} main_engine_thrust
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.main_engine_thrust = 0;

            /**
             * ShipClass main_engine_isp.
             * @member {number} main_engine_isp
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.main_engine_isp = 0;

            /**
             * ShipClass rcs_thrust.
             * @member {galaxy.Vec3.$Properties|null|undefined} rcs_thrust
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.rcs_thrust = null;

            /**
             * ShipClass rcs_torque.
             * @member {galaxy.Vec3.$Properties|null|undefined} rcs_torque
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.rcs_torque = null;

            /**
             * ShipClass rcs_lever.
             * @member {number} rcs_lever
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.rcs_lever = 0;

            /**
             * ShipClass rcs_isp.
             * @member {number} rcs_isp
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.rcs_isp = 0;

            /**
             * ShipClass reaction_wheel_torque.
             * @member {galaxy.Vec3.$Properties|null|undefined} reaction_wheel_torque
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.reaction_wheel_torque = null;

            /**
             * ShipClass reaction_wheel_capacity.
             * @member {galaxy.Vec3.$Properties|null|undefined} reaction_wheel_capacity
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.reaction_wheel_capacity = null;

            /**
             * ShipClass attitude_natural_frequency.
             * @member {number} attitude_natural_frequency
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.attitude_natural_frequency = 0;

            /**
             * ShipClass dry_inertia_ratio.
             * @member {number|null|undefined} dry_inertia_ratio
             * @memberof galaxy.stream.ShipClass
             * @instance
             */
            ShipClass.prototype.dry_inertia_ratio = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(ShipClass.prototype, "_dry_inertia_ratio", {
                get: $util.oneOfGetter($oneOfFields = ["dry_inertia_ratio"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified ShipClass message. Does not implicitly {@link galaxy.stream.ShipClass.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.ShipClass
             * @static
             * @param {galaxy.stream.ShipClass.$Properties} message ShipClass message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ShipClass.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.name != null && $Object.hasOwnProperty.call(message, "name") && message.name !== "")
                    writer.uint32(/* id 1, wireType 2 =*/10).string(message.name);
                if (message.dry_mass != null && $Object.hasOwnProperty.call(message, "dry_mass") && !$Object.is(message.dry_mass, 0))
                    writer.uint32(/* id 2, wireType 1 =*/17).double(message.dry_mass);
                if (message.fuel_capacity != null && $Object.hasOwnProperty.call(message, "fuel_capacity") && !$Object.is(message.fuel_capacity, 0))
                    writer.uint32(/* id 3, wireType 1 =*/25).double(message.fuel_capacity);
                if (message.inertia_tensor != null && $Object.hasOwnProperty.call(message, "inertia_tensor"))
                    $root.galaxy.stream.InertiaTensor.encode(message.inertia_tensor, writer.uint32(/* id 4, wireType 2 =*/34).fork(), _depth + 1).ldelim();
                if (message.ground_contact_offset != null && $Object.hasOwnProperty.call(message, "ground_contact_offset") && !$Object.is(message.ground_contact_offset, 0))
                    writer.uint32(/* id 5, wireType 1 =*/41).double(message.ground_contact_offset);
                if (message.leg_radius != null && $Object.hasOwnProperty.call(message, "leg_radius") && !$Object.is(message.leg_radius, 0))
                    writer.uint32(/* id 6, wireType 1 =*/49).double(message.leg_radius);
                if (message.main_engine_thrust != null && $Object.hasOwnProperty.call(message, "main_engine_thrust") && !$Object.is(message.main_engine_thrust, 0))
                    writer.uint32(/* id 7, wireType 1 =*/57).double(message.main_engine_thrust);
                if (message.main_engine_isp != null && $Object.hasOwnProperty.call(message, "main_engine_isp") && !$Object.is(message.main_engine_isp, 0))
                    writer.uint32(/* id 8, wireType 1 =*/65).double(message.main_engine_isp);
                if (message.rcs_thrust != null && $Object.hasOwnProperty.call(message, "rcs_thrust"))
                    $root.galaxy.Vec3.encode(message.rcs_thrust, writer.uint32(/* id 9, wireType 2 =*/74).fork(), _depth + 1).ldelim();
                if (message.rcs_torque != null && $Object.hasOwnProperty.call(message, "rcs_torque"))
                    $root.galaxy.Vec3.encode(message.rcs_torque, writer.uint32(/* id 10, wireType 2 =*/82).fork(), _depth + 1).ldelim();
                if (message.rcs_lever != null && $Object.hasOwnProperty.call(message, "rcs_lever") && !$Object.is(message.rcs_lever, 0))
                    writer.uint32(/* id 11, wireType 1 =*/89).double(message.rcs_lever);
                if (message.rcs_isp != null && $Object.hasOwnProperty.call(message, "rcs_isp") && !$Object.is(message.rcs_isp, 0))
                    writer.uint32(/* id 12, wireType 1 =*/97).double(message.rcs_isp);
                if (message.reaction_wheel_torque != null && $Object.hasOwnProperty.call(message, "reaction_wheel_torque"))
                    $root.galaxy.Vec3.encode(message.reaction_wheel_torque, writer.uint32(/* id 13, wireType 2 =*/106).fork(), _depth + 1).ldelim();
                if (message.reaction_wheel_capacity != null && $Object.hasOwnProperty.call(message, "reaction_wheel_capacity"))
                    $root.galaxy.Vec3.encode(message.reaction_wheel_capacity, writer.uint32(/* id 14, wireType 2 =*/114).fork(), _depth + 1).ldelim();
                if (message.attitude_natural_frequency != null && $Object.hasOwnProperty.call(message, "attitude_natural_frequency") && !$Object.is(message.attitude_natural_frequency, 0))
                    writer.uint32(/* id 15, wireType 1 =*/121).double(message.attitude_natural_frequency);
                if (message.dry_inertia_ratio != null && $Object.hasOwnProperty.call(message, "dry_inertia_ratio"))
                    writer.uint32(/* id 16, wireType 1 =*/129).double(message.dry_inertia_ratio);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ShipClass message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.ShipClass
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.ShipClass & galaxy.stream.ShipClass.$Shape} ShipClass
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ShipClass.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.ShipClass();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.name = value;
                            else
                                delete message.name;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.dry_mass = value;
                            else
                                delete message.dry_mass;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.fuel_capacity = value;
                            else
                                delete message.fuel_capacity;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 2)
                                break;
                            message.inertia_tensor = $root.galaxy.stream.InertiaTensor.decode(reader, reader.size(), $undefined, _depth + 1, message.inertia_tensor);
                            continue;
                        }
                    case 5: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.ground_contact_offset = value;
                            else
                                delete message.ground_contact_offset;
                            continue;
                        }
                    case 6: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.leg_radius = value;
                            else
                                delete message.leg_radius;
                            continue;
                        }
                    case 7: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.main_engine_thrust = value;
                            else
                                delete message.main_engine_thrust;
                            continue;
                        }
                    case 8: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.main_engine_isp = value;
                            else
                                delete message.main_engine_isp;
                            continue;
                        }
                    case 9: {
                            if (wireType !== 2)
                                break;
                            message.rcs_thrust = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.rcs_thrust);
                            continue;
                        }
                    case 10: {
                            if (wireType !== 2)
                                break;
                            message.rcs_torque = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.rcs_torque);
                            continue;
                        }
                    case 11: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.rcs_lever = value;
                            else
                                delete message.rcs_lever;
                            continue;
                        }
                    case 12: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.rcs_isp = value;
                            else
                                delete message.rcs_isp;
                            continue;
                        }
                    case 13: {
                            if (wireType !== 2)
                                break;
                            message.reaction_wheel_torque = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.reaction_wheel_torque);
                            continue;
                        }
                    case 14: {
                            if (wireType !== 2)
                                break;
                            message.reaction_wheel_capacity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.reaction_wheel_capacity);
                            continue;
                        }
                    case 15: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.attitude_natural_frequency = value;
                            else
                                delete message.attitude_natural_frequency;
                            continue;
                        }
                    case 16: {
                            if (wireType !== 1)
                                break;
                            message.dry_inertia_ratio = reader.double();
                            message._dry_inertia_ratio = "dry_inertia_ratio";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ShipClass;
        })();

        stream.InertiaTensor = (function() {

            /**
             * Properties of an InertiaTensor.
             * @typedef {Object} galaxy.stream.InertiaTensor.$Properties
             * @property {galaxy.Vec3.$Properties|null} [x] InertiaTensor x
             * @property {galaxy.Vec3.$Properties|null} [y] InertiaTensor y
             * @property {galaxy.Vec3.$Properties|null} [z] InertiaTensor z
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of an InertiaTensor.
             * @memberof galaxy.stream
             * @interface IInertiaTensor
             * @augments galaxy.stream.InertiaTensor.$Properties
             * @deprecated Use galaxy.stream.InertiaTensor.$Properties instead.
             */

            /**
             * Shape of an InertiaTensor.
             * @typedef {galaxy.stream.InertiaTensor.$Properties} galaxy.stream.InertiaTensor.$Shape
             */

            /**
             * Constructs a new InertiaTensor.
             * @memberof galaxy.stream
             * @classdesc Represents an InertiaTensor.
             * @constructor
             * @param {galaxy.stream.InertiaTensor.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const InertiaTensor = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * InertiaTensor x.
             * @member {galaxy.Vec3.$Properties|null|undefined} x
             * @memberof galaxy.stream.InertiaTensor
             * @instance
             */
            InertiaTensor.prototype.x = null;

            /**
             * InertiaTensor y.
             * @member {galaxy.Vec3.$Properties|null|undefined} y
             * @memberof galaxy.stream.InertiaTensor
             * @instance
             */
            InertiaTensor.prototype.y = null;

            /**
             * InertiaTensor z.
             * @member {galaxy.Vec3.$Properties|null|undefined} z
             * @memberof galaxy.stream.InertiaTensor
             * @instance
             */
            InertiaTensor.prototype.z = null;

            /**
             * Encodes the specified InertiaTensor message. Does not implicitly {@link galaxy.stream.InertiaTensor.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.InertiaTensor
             * @static
             * @param {galaxy.stream.InertiaTensor.$Properties} message InertiaTensor message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            InertiaTensor.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.x != null && $Object.hasOwnProperty.call(message, "x"))
                    $root.galaxy.Vec3.encode(message.x, writer.uint32(/* id 1, wireType 2 =*/10).fork(), _depth + 1).ldelim();
                if (message.y != null && $Object.hasOwnProperty.call(message, "y"))
                    $root.galaxy.Vec3.encode(message.y, writer.uint32(/* id 2, wireType 2 =*/18).fork(), _depth + 1).ldelim();
                if (message.z != null && $Object.hasOwnProperty.call(message, "z"))
                    $root.galaxy.Vec3.encode(message.z, writer.uint32(/* id 3, wireType 2 =*/26).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes an InertiaTensor message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.InertiaTensor
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.InertiaTensor & galaxy.stream.InertiaTensor.$Shape} InertiaTensor
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            InertiaTensor.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.InertiaTensor();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            message.x = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.x);
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            message.y = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.y);
                            continue;
                        }
                    case 3: {
                            if (wireType !== 2)
                                break;
                            message.z = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.z);
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return InertiaTensor;
        })();

        stream.ServerFrame = (function() {

            /**
             * Properties of a ServerFrame.
             * @typedef {Object} galaxy.stream.ServerFrame.$Properties
             * @property {number|Long|null} [tick] ServerFrame tick
             * @property {number|null} [tick_rate] ServerFrame tick_rate
             * @property {number|null} [time_scale] ServerFrame time_scale
             * @property {boolean|null} [paused] ServerFrame paused
             * @property {Array.<galaxy.physics.BodyState.$Properties>|null} [bodies] ServerFrame bodies
             * @property {Array.<galaxy.physics.ShipState.$Properties>|null} [ships] ServerFrame ships
             * @property {Array.<galaxy.stream.Event.$Properties>|null} [events] ServerFrame events
             * @property {galaxy.stream.InputAcknowledgement.$Properties|null} [last_input] ServerFrame last_input
             * @property {number|null} [game_time] ServerFrame game_time
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ServerFrame.
             * @memberof galaxy.stream
             * @interface IServerFrame
             * @augments galaxy.stream.ServerFrame.$Properties
             * @deprecated Use galaxy.stream.ServerFrame.$Properties instead.
             */

            /**
             * Shape of a ServerFrame.
             * @typedef {galaxy.stream.ServerFrame.$Properties} galaxy.stream.ServerFrame.$Shape
             */

            /**
             * Constructs a new ServerFrame.
             * @memberof galaxy.stream
             * @classdesc Represents a ServerFrame.
             * @constructor
             * @param {galaxy.stream.ServerFrame.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ServerFrame = function (properties) {
                this.bodies = [];
                this.ships = [];
                this.events = [];
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ServerFrame tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * ServerFrame tick_rate.
             * @member {number} tick_rate
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.tick_rate = 0;

            /**
             * ServerFrame time_scale.
             * @member {number} time_scale
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.time_scale = 0;

            /**
             * ServerFrame paused.
             * @member {boolean} paused
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.paused = false;

            /**
             * ServerFrame bodies.
             * @member {Array.<galaxy.physics.BodyState.$Properties>} bodies
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.bodies = $util.emptyArray;

            /**
             * ServerFrame ships.
             * @member {Array.<galaxy.physics.ShipState.$Properties>} ships
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.ships = $util.emptyArray;

            /**
             * ServerFrame events.
             * @member {Array.<galaxy.stream.Event.$Properties>} events
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.events = $util.emptyArray;

            /**
             * ServerFrame last_input.
             * @member {galaxy.stream.InputAcknowledgement.$Properties|null|undefined} last_input
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.last_input = null;

            /**
             * ServerFrame game_time.
             * @member {number|null|undefined} game_time
             * @memberof galaxy.stream.ServerFrame
             * @instance
             */
            ServerFrame.prototype.game_time = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(ServerFrame.prototype, "_game_time", {
                get: $util.oneOfGetter($oneOfFields = ["game_time"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified ServerFrame message. Does not implicitly {@link galaxy.stream.ServerFrame.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.ServerFrame
             * @static
             * @param {galaxy.stream.ServerFrame.$Properties} message ServerFrame message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ServerFrame.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 1, wireType 0 =*/8).uint64(message.tick);
                if (message.tick_rate != null && $Object.hasOwnProperty.call(message, "tick_rate") && !$Object.is(message.tick_rate, 0))
                    writer.uint32(/* id 2, wireType 1 =*/17).double(message.tick_rate);
                if (message.time_scale != null && $Object.hasOwnProperty.call(message, "time_scale") && !$Object.is(message.time_scale, 0))
                    writer.uint32(/* id 3, wireType 1 =*/25).double(message.time_scale);
                if (message.paused != null && $Object.hasOwnProperty.call(message, "paused") && message.paused !== false)
                    writer.uint32(/* id 4, wireType 0 =*/32).bool(message.paused);
                if (message.bodies != null && message.bodies.length)
                    for (let i = 0; i < message.bodies.length; ++i)
                        $root.galaxy.physics.BodyState.encode(message.bodies[i], writer.uint32(/* id 5, wireType 2 =*/42).fork(), _depth + 1).ldelim();
                if (message.ships != null && message.ships.length)
                    for (let i = 0; i < message.ships.length; ++i)
                        $root.galaxy.physics.ShipState.encode(message.ships[i], writer.uint32(/* id 6, wireType 2 =*/50).fork(), _depth + 1).ldelim();
                if (message.events != null && message.events.length)
                    for (let i = 0; i < message.events.length; ++i)
                        $root.galaxy.stream.Event.encode(message.events[i], writer.uint32(/* id 7, wireType 2 =*/58).fork(), _depth + 1).ldelim();
                if (message.last_input != null && $Object.hasOwnProperty.call(message, "last_input"))
                    $root.galaxy.stream.InputAcknowledgement.encode(message.last_input, writer.uint32(/* id 8, wireType 2 =*/66).fork(), _depth + 1).ldelim();
                if (message.game_time != null && $Object.hasOwnProperty.call(message, "game_time"))
                    writer.uint32(/* id 9, wireType 1 =*/73).double(message.game_time);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ServerFrame message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.ServerFrame
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.ServerFrame & galaxy.stream.ServerFrame.$Shape} ServerFrame
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ServerFrame.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.ServerFrame();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.tick_rate = value;
                            else
                                delete message.tick_rate;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.time_scale = value;
                            else
                                delete message.time_scale;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.bool())
                                message.paused = value;
                            else
                                delete message.paused;
                            continue;
                        }
                    case 5: {
                            if (wireType !== 2)
                                break;
                            if (!(message.bodies && message.bodies.length))
                                message.bodies = [];
                            message.bodies.push($root.galaxy.physics.BodyState.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            if (!(message.ships && message.ships.length))
                                message.ships = [];
                            message.ships.push($root.galaxy.physics.ShipState.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    case 7: {
                            if (wireType !== 2)
                                break;
                            if (!(message.events && message.events.length))
                                message.events = [];
                            message.events.push($root.galaxy.stream.Event.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    case 8: {
                            if (wireType !== 2)
                                break;
                            message.last_input = $root.galaxy.stream.InputAcknowledgement.decode(reader, reader.size(), $undefined, _depth + 1, message.last_input);
                            continue;
                        }
                    case 9: {
                            if (wireType !== 1)
                                break;
                            message.game_time = reader.double();
                            message._game_time = "game_time";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ServerFrame;
        })();

        stream.Event = (function() {

            /**
             * Properties of an Event.
             * @typedef {Object} galaxy.stream.Event.$Properties
             * @property {string|null} [type] Event type
             * @property {string|null} [ship_id] Event ship_id
             * @property {number|Long|null} [tick] Event tick
             * @property {number|null} [substep] Event substep
             * @property {boolean|null} [again] Event again
             * @property {string|null} [player_id] Event player_id
             * @property {string|null} [body] Event body
             * @property {string|null} [reason] Event reason
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of an Event.
             * @memberof galaxy.stream
             * @interface IEvent
             * @augments galaxy.stream.Event.$Properties
             * @deprecated Use galaxy.stream.Event.$Properties instead.
             */

            /**
             * Shape of an Event.
             * @typedef {galaxy.stream.Event.$Properties} galaxy.stream.Event.$Shape
             */

            /**
             * Constructs a new Event.
             * @memberof galaxy.stream
             * @classdesc Represents an Event.
             * @constructor
             * @param {galaxy.stream.Event.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Event = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Event type.
             * @member {string} type
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.type = "";

            /**
             * Event ship_id.
             * @member {string} ship_id
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.ship_id = "";

            /**
             * Event tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Event substep.
             * @member {number|null|undefined} substep
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.substep = null;

            /**
             * Event again.
             * @member {boolean} again
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.again = false;

            /**
             * Event player_id.
             * @member {string} player_id
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.player_id = "";

            /**
             * Event body.
             * @member {string} body
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.body = "";

            /**
             * Event reason.
             * @member {string} reason
             * @memberof galaxy.stream.Event
             * @instance
             */
            Event.prototype.reason = "";

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(Event.prototype, "_substep", {
                get: $util.oneOfGetter($oneOfFields = ["substep"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified Event message. Does not implicitly {@link galaxy.stream.Event.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Event
             * @static
             * @param {galaxy.stream.Event.$Properties} message Event message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Event.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.type != null && $Object.hasOwnProperty.call(message, "type") && message.type !== "")
                    writer.uint32(/* id 1, wireType 2 =*/10).string(message.type);
                if (message.ship_id != null && $Object.hasOwnProperty.call(message, "ship_id") && message.ship_id !== "")
                    writer.uint32(/* id 2, wireType 2 =*/18).string(message.ship_id);
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 3, wireType 0 =*/24).uint64(message.tick);
                if (message.substep != null && $Object.hasOwnProperty.call(message, "substep"))
                    writer.uint32(/* id 4, wireType 0 =*/32).uint32(message.substep);
                if (message.again != null && $Object.hasOwnProperty.call(message, "again") && message.again !== false)
                    writer.uint32(/* id 5, wireType 0 =*/40).bool(message.again);
                if (message.player_id != null && $Object.hasOwnProperty.call(message, "player_id") && message.player_id !== "")
                    writer.uint32(/* id 6, wireType 2 =*/50).string(message.player_id);
                if (message.body != null && $Object.hasOwnProperty.call(message, "body") && message.body !== "")
                    writer.uint32(/* id 7, wireType 2 =*/58).string(message.body);
                if (message.reason != null && $Object.hasOwnProperty.call(message, "reason") && message.reason !== "")
                    writer.uint32(/* id 8, wireType 2 =*/66).string(message.reason);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes an Event message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Event
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Event & galaxy.stream.Event.$Shape} Event
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Event.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Event();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.type = value;
                            else
                                delete message.type;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.ship_id = value;
                            else
                                delete message.ship_id;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 0)
                                break;
                            message.substep = reader.uint32();
                            message._substep = "substep";
                            continue;
                        }
                    case 5: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.bool())
                                message.again = value;
                            else
                                delete message.again;
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.player_id = value;
                            else
                                delete message.player_id;
                            continue;
                        }
                    case 7: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.body = value;
                            else
                                delete message.body;
                            continue;
                        }
                    case 8: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.reason = value;
                            else
                                delete message.reason;
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Event;
        })();

        stream.InputAcknowledgement = (function() {

            /**
             * Properties of an InputAcknowledgement.
             * @typedef {Object} galaxy.stream.InputAcknowledgement.$Properties
             * @property {number|Long|null} [seq] InputAcknowledgement seq
             * @property {number|Long|null} [tick] InputAcknowledgement tick
             * @property {number|null} [substep] InputAcknowledgement substep
             * @property {number|null} [margin] InputAcknowledgement margin
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of an InputAcknowledgement.
             * @memberof galaxy.stream
             * @interface IInputAcknowledgement
             * @augments galaxy.stream.InputAcknowledgement.$Properties
             * @deprecated Use galaxy.stream.InputAcknowledgement.$Properties instead.
             */

            /**
             * Shape of an InputAcknowledgement.
             * @typedef {galaxy.stream.InputAcknowledgement.$Properties} galaxy.stream.InputAcknowledgement.$Shape
             */

            /**
             * Constructs a new InputAcknowledgement.
             * @memberof galaxy.stream
             * @classdesc Represents an InputAcknowledgement.
             * @constructor
             * @param {galaxy.stream.InputAcknowledgement.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const InputAcknowledgement = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * InputAcknowledgement seq.
             * @member {number|Long} seq
             * @memberof galaxy.stream.InputAcknowledgement
             * @instance
             */
            InputAcknowledgement.prototype.seq = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * InputAcknowledgement tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.InputAcknowledgement
             * @instance
             */
            InputAcknowledgement.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * InputAcknowledgement substep.
             * @member {number} substep
             * @memberof galaxy.stream.InputAcknowledgement
             * @instance
             */
            InputAcknowledgement.prototype.substep = 0;

            /**
             * InputAcknowledgement margin.
             * @member {number} margin
             * @memberof galaxy.stream.InputAcknowledgement
             * @instance
             */
            InputAcknowledgement.prototype.margin = 0;

            /**
             * Encodes the specified InputAcknowledgement message. Does not implicitly {@link galaxy.stream.InputAcknowledgement.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.InputAcknowledgement
             * @static
             * @param {galaxy.stream.InputAcknowledgement.$Properties} message InputAcknowledgement message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            InputAcknowledgement.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.seq != null && $Object.hasOwnProperty.call(message, "seq") && (typeof message.seq === "object" ? message.seq.low || message.seq.high : message.seq !== 0))
                    writer.uint32(/* id 1, wireType 0 =*/8).uint64(message.seq);
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 2, wireType 0 =*/16).uint64(message.tick);
                if (message.substep != null && $Object.hasOwnProperty.call(message, "substep") && message.substep !== 0)
                    writer.uint32(/* id 3, wireType 0 =*/24).uint32(message.substep);
                if (message.margin != null && $Object.hasOwnProperty.call(message, "margin") && !$Object.is(message.margin, 0))
                    writer.uint32(/* id 4, wireType 1 =*/33).double(message.margin);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes an InputAcknowledgement message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.InputAcknowledgement
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.InputAcknowledgement & galaxy.stream.InputAcknowledgement.$Shape} InputAcknowledgement
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            InputAcknowledgement.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.InputAcknowledgement();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.seq = value;
                            else
                                delete message.seq;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.uint32())
                                message.substep = value;
                            else
                                delete message.substep;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.margin = value;
                            else
                                delete message.margin;
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return InputAcknowledgement;
        })();

        stream.Pong = (function() {

            /**
             * Properties of a Pong.
             * @typedef {Object} galaxy.stream.Pong.$Properties
             * @property {number|Long|null} [id] Pong id
             * @property {number|Long|null} [tick] Pong tick
             * @property {number|null} [since_tick] Pong since_tick
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a Pong.
             * @memberof galaxy.stream
             * @interface IPong
             * @augments galaxy.stream.Pong.$Properties
             * @deprecated Use galaxy.stream.Pong.$Properties instead.
             */

            /**
             * Shape of a Pong.
             * @typedef {galaxy.stream.Pong.$Properties} galaxy.stream.Pong.$Shape
             */

            /**
             * Constructs a new Pong.
             * @memberof galaxy.stream
             * @classdesc Represents a Pong.
             * @constructor
             * @param {galaxy.stream.Pong.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Pong = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Pong id.
             * @member {number|Long} id
             * @memberof galaxy.stream.Pong
             * @instance
             */
            Pong.prototype.id = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Pong tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.Pong
             * @instance
             */
            Pong.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Pong since_tick.
             * @member {number} since_tick
             * @memberof galaxy.stream.Pong
             * @instance
             */
            Pong.prototype.since_tick = 0;

            /**
             * Encodes the specified Pong message. Does not implicitly {@link galaxy.stream.Pong.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Pong
             * @static
             * @param {galaxy.stream.Pong.$Properties} message Pong message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Pong.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.id != null && $Object.hasOwnProperty.call(message, "id") && (typeof message.id === "object" ? message.id.low || message.id.high : message.id !== 0))
                    writer.uint32(/* id 1, wireType 0 =*/8).uint64(message.id);
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 2, wireType 0 =*/16).uint64(message.tick);
                if (message.since_tick != null && $Object.hasOwnProperty.call(message, "since_tick") && !$Object.is(message.since_tick, 0))
                    writer.uint32(/* id 3, wireType 1 =*/25).double(message.since_tick);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a Pong message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Pong
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Pong & galaxy.stream.Pong.$Shape} Pong
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Pong.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Pong();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.id = value;
                            else
                                delete message.id;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.since_tick = value;
                            else
                                delete message.since_tick;
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Pong;
        })();

        stream.ClientFrame = (function() {

            /**
             * Properties of a ClientFrame.
             * @typedef {Object} galaxy.stream.ClientFrame.$Properties
             * @property {Array.<galaxy.stream.Input.$Properties>|null} [inputs] ClientFrame inputs
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ClientFrame.
             * @memberof galaxy.stream
             * @interface IClientFrame
             * @augments galaxy.stream.ClientFrame.$Properties
             * @deprecated Use galaxy.stream.ClientFrame.$Properties instead.
             */

            /**
             * Shape of a ClientFrame.
             * @typedef {galaxy.stream.ClientFrame.$Properties} galaxy.stream.ClientFrame.$Shape
             */

            /**
             * Constructs a new ClientFrame.
             * @memberof galaxy.stream
             * @classdesc Represents a ClientFrame.
             * @constructor
             * @param {galaxy.stream.ClientFrame.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ClientFrame = function (properties) {
                this.inputs = [];
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ClientFrame inputs.
             * @member {Array.<galaxy.stream.Input.$Properties>} inputs
             * @memberof galaxy.stream.ClientFrame
             * @instance
             */
            ClientFrame.prototype.inputs = $util.emptyArray;

            /**
             * Encodes the specified ClientFrame message. Does not implicitly {@link galaxy.stream.ClientFrame.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.ClientFrame
             * @static
             * @param {galaxy.stream.ClientFrame.$Properties} message ClientFrame message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ClientFrame.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.inputs != null && message.inputs.length)
                    for (let i = 0; i < message.inputs.length; ++i)
                        $root.galaxy.stream.Input.encode(message.inputs[i], writer.uint32(/* id 1, wireType 2 =*/10).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ClientFrame message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.ClientFrame
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.ClientFrame & galaxy.stream.ClientFrame.$Shape} ClientFrame
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ClientFrame.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.ClientFrame();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if (!(message.inputs && message.inputs.length))
                                message.inputs = [];
                            message.inputs.push($root.galaxy.stream.Input.decode(reader, reader.size(), $undefined, _depth + 1));
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ClientFrame;
        })();

        stream.Input = (function() {

            /**
             * Properties of an Input.
             * @typedef {Object} galaxy.stream.Input.$Properties
             * @property {number|Long|null} [seq] Input seq
             * @property {number|Long|null} [tick] Input tick
             * @property {number|null} [substep] Input substep
             * @property {galaxy.stream.Controls.$Properties|null} [controls] Input controls
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of an Input.
             * @memberof galaxy.stream
             * @interface IInput
             * @augments galaxy.stream.Input.$Properties
             * @deprecated Use galaxy.stream.Input.$Properties instead.
             */

            /**
             * Shape of an Input.
             * @typedef {galaxy.stream.Input.$Properties} galaxy.stream.Input.$Shape
             */

            /**
             * Constructs a new Input.
             * @memberof galaxy.stream
             * @classdesc Represents an Input.
             * @constructor
             * @param {galaxy.stream.Input.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Input = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Input seq.
             * @member {number|Long} seq
             * @memberof galaxy.stream.Input
             * @instance
             */
            Input.prototype.seq = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Input tick.
             * @member {number|Long} tick
             * @memberof galaxy.stream.Input
             * @instance
             */
            Input.prototype.tick = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Input substep.
             * @member {number} substep
             * @memberof galaxy.stream.Input
             * @instance
             */
            Input.prototype.substep = 0;

            /**
             * Input controls.
             * @member {galaxy.stream.Controls.$Properties|null|undefined} controls
             * @memberof galaxy.stream.Input
             * @instance
             */
            Input.prototype.controls = null;

            /**
             * Encodes the specified Input message. Does not implicitly {@link galaxy.stream.Input.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Input
             * @static
             * @param {galaxy.stream.Input.$Properties} message Input message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Input.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.seq != null && $Object.hasOwnProperty.call(message, "seq") && (typeof message.seq === "object" ? message.seq.low || message.seq.high : message.seq !== 0))
                    writer.uint32(/* id 1, wireType 0 =*/8).uint64(message.seq);
                if (message.tick != null && $Object.hasOwnProperty.call(message, "tick") && (typeof message.tick === "object" ? message.tick.low || message.tick.high : message.tick !== 0))
                    writer.uint32(/* id 2, wireType 0 =*/16).uint64(message.tick);
                if (message.substep != null && $Object.hasOwnProperty.call(message, "substep") && message.substep !== 0)
                    writer.uint32(/* id 3, wireType 0 =*/24).uint32(message.substep);
                if (message.controls != null && $Object.hasOwnProperty.call(message, "controls"))
                    $root.galaxy.stream.Controls.encode(message.controls, writer.uint32(/* id 4, wireType 2 =*/34).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes an Input message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Input
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Input & galaxy.stream.Input.$Shape} Input
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Input.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Input();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.seq = value;
                            else
                                delete message.seq;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.tick = value;
                            else
                                delete message.tick;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.uint32())
                                message.substep = value;
                            else
                                delete message.substep;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 2)
                                break;
                            message.controls = $root.galaxy.stream.Controls.decode(reader, reader.size(), $undefined, _depth + 1, message.controls);
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Input;
        })();

        stream.Controls = (function() {

            /**
             * Properties of a Controls.
             * @typedef {Object} galaxy.stream.Controls.$Properties
             * @property {number|null} [thrust_level] Controls thrust_level
             * @property {galaxy.Vec3.$Properties|null} [translation_input] Controls translation_input
             * @property {galaxy.Vec3.$Properties|null} [rotation_input] Controls rotation_input
             * @property {boolean|null} [attitude_hold] Controls attitude_hold
             * @property {string|null} [attitude_mode] Controls attitude_mode
             * @property {galaxy.Quaternion.$Properties|null} [target_attitude] Controls target_attitude
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a Controls.
             * @memberof galaxy.stream
             * @interface IControls
             * @augments galaxy.stream.Controls.$Properties
             * @deprecated Use galaxy.stream.Controls.$Properties instead.
             */

            /**
             * Shape of a Controls.
             * @typedef {galaxy.stream.Controls.$Properties} galaxy.stream.Controls.$Shape
             */

            /**
             * Constructs a new Controls.
             * @memberof galaxy.stream
             * @classdesc Represents a Controls.
             * @constructor
             * @param {galaxy.stream.Controls.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Controls = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Controls thrust_level.
             * @member {number} thrust_level
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.thrust_level = 0;

            /**
             * Controls translation_input.
             * @member {galaxy.Vec3.$Properties|null|undefined} translation_input
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.translation_input = null;

            /**
             * Controls rotation_input.
             * @member {galaxy.Vec3.$Properties|null|undefined} rotation_input
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.rotation_input = null;

            /**
             * Controls attitude_hold.
             * @member {boolean} attitude_hold
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.attitude_hold = false;

            /**
             * Controls attitude_mode.
             * @member {string} attitude_mode
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.attitude_mode = "";

            /**
             * Controls target_attitude.
             * @member {galaxy.Quaternion.$Properties|null|undefined} target_attitude
             * @memberof galaxy.stream.Controls
             * @instance
             */
            Controls.prototype.target_attitude = null;

            /**
             * Encodes the specified Controls message. Does not implicitly {@link galaxy.stream.Controls.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Controls
             * @static
             * @param {galaxy.stream.Controls.$Properties} message Controls message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Controls.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.thrust_level != null && $Object.hasOwnProperty.call(message, "thrust_level") && !$Object.is(message.thrust_level, 0))
                    writer.uint32(/* id 1, wireType 1 =*/9).double(message.thrust_level);
                if (message.translation_input != null && $Object.hasOwnProperty.call(message, "translation_input"))
                    $root.galaxy.Vec3.encode(message.translation_input, writer.uint32(/* id 2, wireType 2 =*/18).fork(), _depth + 1).ldelim();
                if (message.rotation_input != null && $Object.hasOwnProperty.call(message, "rotation_input"))
                    $root.galaxy.Vec3.encode(message.rotation_input, writer.uint32(/* id 3, wireType 2 =*/26).fork(), _depth + 1).ldelim();
                if (message.attitude_hold != null && $Object.hasOwnProperty.call(message, "attitude_hold") && message.attitude_hold !== false)
                    writer.uint32(/* id 4, wireType 0 =*/32).bool(message.attitude_hold);
                if (message.attitude_mode != null && $Object.hasOwnProperty.call(message, "attitude_mode") && message.attitude_mode !== "")
                    writer.uint32(/* id 5, wireType 2 =*/42).string(message.attitude_mode);
                if (message.target_attitude != null && $Object.hasOwnProperty.call(message, "target_attitude"))
                    $root.galaxy.Quaternion.encode(message.target_attitude, writer.uint32(/* id 6, wireType 2 =*/50).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a Controls message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Controls
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Controls & galaxy.stream.Controls.$Shape} Controls
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Controls.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Controls();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.thrust_level = value;
                            else
                                delete message.thrust_level;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            message.translation_input = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.translation_input);
                            continue;
                        }
                    case 3: {
                            if (wireType !== 2)
                                break;
                            message.rotation_input = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.rotation_input);
                            continue;
                        }
                    case 4: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.bool())
                                message.attitude_hold = value;
                            else
                                delete message.attitude_hold;
                            continue;
                        }
                    case 5: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.attitude_mode = value;
                            else
                                delete message.attitude_mode;
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            message.target_attitude = $root.galaxy.Quaternion.decode(reader, reader.size(), $undefined, _depth + 1, message.target_attitude);
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Controls;
        })();

        stream.Ping = (function() {

            /**
             * Properties of a Ping.
             * @typedef {Object} galaxy.stream.Ping.$Properties
             * @property {number|Long|null} [id] Ping id
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a Ping.
             * @memberof galaxy.stream
             * @interface IPing
             * @augments galaxy.stream.Ping.$Properties
             * @deprecated Use galaxy.stream.Ping.$Properties instead.
             */

            /**
             * Shape of a Ping.
             * @typedef {galaxy.stream.Ping.$Properties} galaxy.stream.Ping.$Shape
             */

            /**
             * Constructs a new Ping.
             * @memberof galaxy.stream
             * @classdesc Represents a Ping.
             * @constructor
             * @param {galaxy.stream.Ping.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const Ping = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * Ping id.
             * @member {number|Long} id
             * @memberof galaxy.stream.Ping
             * @instance
             */
            Ping.prototype.id = $util.Long ? $util.Long.fromBits(0,0,true) : 0;

            /**
             * Encodes the specified Ping message. Does not implicitly {@link galaxy.stream.Ping.verify|verify} messages.
             * @function encode
             * @memberof galaxy.stream.Ping
             * @static
             * @param {galaxy.stream.Ping.$Properties} message Ping message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            Ping.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.id != null && $Object.hasOwnProperty.call(message, "id") && (typeof message.id === "object" ? message.id.low || message.id.high : message.id !== 0))
                    writer.uint32(/* id 1, wireType 0 =*/8).uint64(message.id);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a Ping message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.stream.Ping
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.stream.Ping & galaxy.stream.Ping.$Shape} Ping
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            Ping.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.stream.Ping();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 0)
                                break;
                            if (typeof (value = reader.uint64()) === "object" ? value.low || value.high : value !== 0)
                                message.id = value;
                            else
                                delete message.id;
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return Ping;
        })();

        return stream;
    })();

    galaxy.Vec3 = (function() {

        /**
         * Properties of a Vec3.
         * @typedef {Object} galaxy.Vec3.$Properties
         * @property {number|null} [x] Vec3 x
         * @property {number|null} [y] Vec3 y
         * @property {number|null} [z] Vec3 z
         * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
         */

        /**
         * Properties of a Vec3.
         * @memberof galaxy
         * @interface IVec3
         * @augments galaxy.Vec3.$Properties
         * @deprecated Use galaxy.Vec3.$Properties instead.
         */

        /**
         * Shape of a Vec3.
         * @typedef {galaxy.Vec3.$Properties} galaxy.Vec3.$Shape
         */

        /**
         * Constructs a new Vec3.
         * @memberof galaxy
         * @classdesc Represents a Vec3.
         * @constructor
         * @param {galaxy.Vec3.$Properties=} [properties] Properties to set
         * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
         */
        const Vec3 = function (properties) {
            if (properties)
                for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                    if (properties[keys[i]] != null && keys[i] !== "__proto__")
                        this[keys[i]] = properties[keys[i]];
        };

        /**
         * Vec3 x.
         * @member {number} x
         * @memberof galaxy.Vec3
         * @instance
         */
        Vec3.prototype.x = 0;

        /**
         * Vec3 y.
         * @member {number} y
         * @memberof galaxy.Vec3
         * @instance
         */
        Vec3.prototype.y = 0;

        /**
         * Vec3 z.
         * @member {number} z
         * @memberof galaxy.Vec3
         * @instance
         */
        Vec3.prototype.z = 0;

        /**
         * Encodes the specified Vec3 message. Does not implicitly {@link galaxy.Vec3.verify|verify} messages.
         * @function encode
         * @memberof galaxy.Vec3
         * @static
         * @param {galaxy.Vec3.$Properties} message Vec3 message or plain object to encode
         * @param {$protobuf.Writer} [writer] Writer to encode to
         * @returns {$protobuf.Writer} Writer
         */
        Vec3.encode = function (message, writer, _depth) {
            if (!writer)
                writer = $Writer.create();
            if (_depth === $undefined)
                _depth = 0;
            if (_depth > $util.recursionLimit)
                throw $Error("max depth exceeded");
            if (message.x != null && $Object.hasOwnProperty.call(message, "x") && !$Object.is(message.x, 0))
                writer.uint32(/* id 1, wireType 1 =*/9).double(message.x);
            if (message.y != null && $Object.hasOwnProperty.call(message, "y") && !$Object.is(message.y, 0))
                writer.uint32(/* id 2, wireType 1 =*/17).double(message.y);
            if (message.z != null && $Object.hasOwnProperty.call(message, "z") && !$Object.is(message.z, 0))
                writer.uint32(/* id 3, wireType 1 =*/25).double(message.z);
            if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                for (let i = 0; i < message.$unknowns.length; ++i)
                    writer.raw(message.$unknowns[i]);
            return writer;
        };

        /**
         * Decodes a Vec3 message from the specified reader or buffer.
         * @function decode
         * @memberof galaxy.Vec3
         * @static
         * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
         * @param {number} [length] Message length if known beforehand
         * @returns {galaxy.Vec3 & galaxy.Vec3.$Shape} Vec3
         * @throws {Error} If the payload is not a reader or valid buffer
         * @throws {$protobuf.util.ProtocolError} If required fields are missing
         */
        Vec3.decode = function (reader, length, _end, _depth, _target) {
            if (!(reader instanceof $Reader))
                reader = $Reader.create(reader);
            if (_depth === $undefined)
                _depth = 0;
            if (_depth > $Reader.recursionLimit)
                throw $Error("max depth exceeded");
            let end, message, value;
            if (length === $undefined)
                end = reader.len;
            else {
                end = reader.pos + length;
                if (end > reader.len)
                    throw $RangeError("index out of range");
                length = reader.len;
                reader.len = end;
            }
            message = _target || new $root.galaxy.Vec3();
            while (reader.pos < end) {
                let start = reader.pos;
                let tag = reader.tag();
                if (tag === _end) {
                    _end = $undefined;
                    break;
                }
                let wireType = tag & 7;
                switch (tag >>>= 3) {
                case 1: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.x = value;
                        else
                            delete message.x;
                        continue;
                    }
                case 2: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.y = value;
                        else
                            delete message.y;
                        continue;
                    }
                case 3: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.z = value;
                        else
                            delete message.z;
                        continue;
                    }
                }
                reader.skipType(wireType, _depth, tag);
                if (!reader.discardUnknown) {
                    $util.makeProp(message, "$unknowns", false);
                    (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                }
            }
            if (length !== $undefined) {
                if (reader.pos !== end)
                    throw $RangeError("index out of range");
                reader.len = length;
            }
            if (_end !== $undefined)
                throw $Error("missing end group");
            return message;
        };

        return Vec3;
    })();

    galaxy.Quaternion = (function() {

        /**
         * Properties of a Quaternion.
         * @typedef {Object} galaxy.Quaternion.$Properties
         * @property {number|null} [w] Quaternion w
         * @property {number|null} [x] Quaternion x
         * @property {number|null} [y] Quaternion y
         * @property {number|null} [z] Quaternion z
         * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
         */

        /**
         * Properties of a Quaternion.
         * @memberof galaxy
         * @interface IQuaternion
         * @augments galaxy.Quaternion.$Properties
         * @deprecated Use galaxy.Quaternion.$Properties instead.
         */

        /**
         * Shape of a Quaternion.
         * @typedef {galaxy.Quaternion.$Properties} galaxy.Quaternion.$Shape
         */

        /**
         * Constructs a new Quaternion.
         * @memberof galaxy
         * @classdesc Represents a Quaternion.
         * @constructor
         * @param {galaxy.Quaternion.$Properties=} [properties] Properties to set
         * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
         */
        const Quaternion = function (properties) {
            if (properties)
                for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                    if (properties[keys[i]] != null && keys[i] !== "__proto__")
                        this[keys[i]] = properties[keys[i]];
        };

        /**
         * Quaternion w.
         * @member {number} w
         * @memberof galaxy.Quaternion
         * @instance
         */
        Quaternion.prototype.w = 0;

        /**
         * Quaternion x.
         * @member {number} x
         * @memberof galaxy.Quaternion
         * @instance
         */
        Quaternion.prototype.x = 0;

        /**
         * Quaternion y.
         * @member {number} y
         * @memberof galaxy.Quaternion
         * @instance
         */
        Quaternion.prototype.y = 0;

        /**
         * Quaternion z.
         * @member {number} z
         * @memberof galaxy.Quaternion
         * @instance
         */
        Quaternion.prototype.z = 0;

        /**
         * Encodes the specified Quaternion message. Does not implicitly {@link galaxy.Quaternion.verify|verify} messages.
         * @function encode
         * @memberof galaxy.Quaternion
         * @static
         * @param {galaxy.Quaternion.$Properties} message Quaternion message or plain object to encode
         * @param {$protobuf.Writer} [writer] Writer to encode to
         * @returns {$protobuf.Writer} Writer
         */
        Quaternion.encode = function (message, writer, _depth) {
            if (!writer)
                writer = $Writer.create();
            if (_depth === $undefined)
                _depth = 0;
            if (_depth > $util.recursionLimit)
                throw $Error("max depth exceeded");
            if (message.w != null && $Object.hasOwnProperty.call(message, "w") && !$Object.is(message.w, 0))
                writer.uint32(/* id 1, wireType 1 =*/9).double(message.w);
            if (message.x != null && $Object.hasOwnProperty.call(message, "x") && !$Object.is(message.x, 0))
                writer.uint32(/* id 2, wireType 1 =*/17).double(message.x);
            if (message.y != null && $Object.hasOwnProperty.call(message, "y") && !$Object.is(message.y, 0))
                writer.uint32(/* id 3, wireType 1 =*/25).double(message.y);
            if (message.z != null && $Object.hasOwnProperty.call(message, "z") && !$Object.is(message.z, 0))
                writer.uint32(/* id 4, wireType 1 =*/33).double(message.z);
            if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                for (let i = 0; i < message.$unknowns.length; ++i)
                    writer.raw(message.$unknowns[i]);
            return writer;
        };

        /**
         * Decodes a Quaternion message from the specified reader or buffer.
         * @function decode
         * @memberof galaxy.Quaternion
         * @static
         * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
         * @param {number} [length] Message length if known beforehand
         * @returns {galaxy.Quaternion & galaxy.Quaternion.$Shape} Quaternion
         * @throws {Error} If the payload is not a reader or valid buffer
         * @throws {$protobuf.util.ProtocolError} If required fields are missing
         */
        Quaternion.decode = function (reader, length, _end, _depth, _target) {
            if (!(reader instanceof $Reader))
                reader = $Reader.create(reader);
            if (_depth === $undefined)
                _depth = 0;
            if (_depth > $Reader.recursionLimit)
                throw $Error("max depth exceeded");
            let end, message, value;
            if (length === $undefined)
                end = reader.len;
            else {
                end = reader.pos + length;
                if (end > reader.len)
                    throw $RangeError("index out of range");
                length = reader.len;
                reader.len = end;
            }
            message = _target || new $root.galaxy.Quaternion();
            while (reader.pos < end) {
                let start = reader.pos;
                let tag = reader.tag();
                if (tag === _end) {
                    _end = $undefined;
                    break;
                }
                let wireType = tag & 7;
                switch (tag >>>= 3) {
                case 1: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.w = value;
                        else
                            delete message.w;
                        continue;
                    }
                case 2: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.x = value;
                        else
                            delete message.x;
                        continue;
                    }
                case 3: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.y = value;
                        else
                            delete message.y;
                        continue;
                    }
                case 4: {
                        if (wireType !== 1)
                            break;
                        if (!$Object.is(value = reader.double(), 0))
                            message.z = value;
                        else
                            delete message.z;
                        continue;
                    }
                }
                reader.skipType(wireType, _depth, tag);
                if (!reader.discardUnknown) {
                    $util.makeProp(message, "$unknowns", false);
                    (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                }
            }
            if (length !== $undefined) {
                if (reader.pos !== end)
                    throw $RangeError("index out of range");
                reader.len = length;
            }
            if (_end !== $undefined)
                throw $Error("missing end group");
            return message;
        };

        return Quaternion;
    })();

    galaxy.physics = (function() {

        /**
         * Namespace physics.
         * @memberof galaxy
         * @namespace
         */
        const physics = {};

        physics.ShipState = (function() {

            /**
             * Properties of a ShipState.
             * @typedef {Object} galaxy.physics.ShipState.$Properties
             * @property {string|null} [ship_id] ShipState ship_id
             * @property {string|null} [player_id] ShipState player_id
             * @property {string|null} [name] ShipState name
             * @property {string|null} [ship_class] ShipState ship_class
             * @property {galaxy.Vec3.$Properties|null} [position] ShipState position
             * @property {galaxy.Vec3.$Properties|null} [velocity] ShipState velocity
             * @property {galaxy.Quaternion.$Properties|null} [attitude] ShipState attitude
             * @property {galaxy.Vec3.$Properties|null} [angular_velocity] ShipState angular_velocity
             * @property {galaxy.Vec3.$Properties|null} [rotation_input] ShipState rotation_input
             * @property {galaxy.Vec3.$Properties|null} [translation_input] ShipState translation_input
             * @property {number|null} [thrust_level] ShipState thrust_level
             * @property {boolean|null} [attitude_hold] ShipState attitude_hold
             * @property {string|null} [attitude_mode] ShipState attitude_mode
             * @property {galaxy.Quaternion.$Properties|null} [target_attitude] ShipState target_attitude
             * @property {number|null} [fuel] ShipState fuel
             * @property {number|null} [mass] ShipState mass
             * @property {string|null} [landed_body_name] ShipState landed_body_name
             * @property {string|null} [surface_contact_state] ShipState surface_contact_state
             * @property {number|null} [contact_impact_speed] ShipState contact_impact_speed
             * @property {string|null} [reference_body] ShipState reference_body
             * @property {galaxy.Vec3.$Properties|null} [relative_position] ShipState relative_position
             * @property {galaxy.Vec3.$Properties|null} [relative_velocity] ShipState relative_velocity
             * @property {boolean|null} [crashed] ShipState crashed
             * @property {galaxy.Vec3.$Properties|null} [wheel_momentum] ShipState wheel_momentum
             * @property {number|null} [ground_contact_offset] ShipState ground_contact_offset
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a ShipState.
             * @memberof galaxy.physics
             * @interface IShipState
             * @augments galaxy.physics.ShipState.$Properties
             * @deprecated Use galaxy.physics.ShipState.$Properties instead.
             */

            /**
             * Shape of a ShipState.
             * @typedef {galaxy.physics.ShipState.$Properties} galaxy.physics.ShipState.$Shape
             */

            /**
             * Constructs a new ShipState.
             * @memberof galaxy.physics
             * @classdesc Represents a ShipState.
             * @constructor
             * @param {galaxy.physics.ShipState.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const ShipState = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * ShipState ship_id.
             * @member {string} ship_id
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.ship_id = "";

            /**
             * ShipState player_id.
             * @member {string} player_id
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.player_id = "";

            /**
             * ShipState name.
             * @member {string} name
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.name = "";

            /**
             * ShipState ship_class.
             * @member {string} ship_class
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.ship_class = "";

            /**
             * ShipState position.
             * @member {galaxy.Vec3.$Properties|null|undefined} position
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.position = null;

            /**
             * ShipState velocity.
             * @member {galaxy.Vec3.$Properties|null|undefined} velocity
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.velocity = null;

            /**
             * ShipState attitude.
             * @member {galaxy.Quaternion.$Properties|null|undefined} attitude
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.attitude = null;

            /**
             * ShipState angular_velocity.
             * @member {galaxy.Vec3.$Properties|null|undefined} angular_velocity
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.angular_velocity = null;

            /**
             * ShipState rotation_input.
             * @member {galaxy.Vec3.$Properties|null|undefined} rotation_input
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.rotation_input = null;

            /**
             * ShipState translation_input.
             * @member {galaxy.Vec3.$Properties|null|undefined} translation_input
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.translation_input = null;

            /**
             * ShipState thrust_level.
             * @member {number} thrust_level
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.thrust_level = 0;

            /**
             * ShipState attitude_hold.
             * @member {boolean} attitude_hold
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.attitude_hold = false;

            /**
             * ShipState attitude_mode.
             * @member {string} attitude_mode
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.attitude_mode = "";

            /**
             * ShipState target_attitude.
             * @member {galaxy.Quaternion.$Properties|null|undefined} target_attitude
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.target_attitude = null;

            /**
             * ShipState fuel.
             * @member {number} fuel
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.fuel = 0;

            /**
             * ShipState mass.
             * @member {number} mass
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.mass = 0;

            /**
             * ShipState landed_body_name.
             * @member {string} landed_body_name
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.landed_body_name = "";

            /**
             * ShipState surface_contact_state.
             * @member {string} surface_contact_state
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.surface_contact_state = "";

            /**
             * ShipState contact_impact_speed.
             * @member {number} contact_impact_speed
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.contact_impact_speed = 0;

            /**
             * ShipState reference_body.
             * @member {string} reference_body
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.reference_body = "";

            /**
             * ShipState relative_position.
             * @member {galaxy.Vec3.$Properties|null|undefined} relative_position
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.relative_position = null;

            /**
             * ShipState relative_velocity.
             * @member {galaxy.Vec3.$Properties|null|undefined} relative_velocity
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.relative_velocity = null;

            /**
             * ShipState crashed.
             * @member {boolean} crashed
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.crashed = false;

            /**
             * ShipState wheel_momentum.
             * @member {galaxy.Vec3.$Properties|null|undefined} wheel_momentum
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.wheel_momentum = null;

            /**
             * ShipState ground_contact_offset.
             * @member {number|null|undefined} ground_contact_offset
             * @memberof galaxy.physics.ShipState
             * @instance
             */
            ShipState.prototype.ground_contact_offset = null;

            // OneOf field names bound to virtual getters and setters
            let $oneOfFields;

            // Virtual OneOf for proto3 optional field
            $Object.defineProperty(ShipState.prototype, "_ground_contact_offset", {
                get: $util.oneOfGetter($oneOfFields = ["ground_contact_offset"]),
                set: $util.oneOfSetter($oneOfFields)
            });

            /**
             * Encodes the specified ShipState message. Does not implicitly {@link galaxy.physics.ShipState.verify|verify} messages.
             * @function encode
             * @memberof galaxy.physics.ShipState
             * @static
             * @param {galaxy.physics.ShipState.$Properties} message ShipState message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            ShipState.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.ship_id != null && $Object.hasOwnProperty.call(message, "ship_id") && message.ship_id !== "")
                    writer.uint32(/* id 1, wireType 2 =*/10).string(message.ship_id);
                if (message.player_id != null && $Object.hasOwnProperty.call(message, "player_id") && message.player_id !== "")
                    writer.uint32(/* id 2, wireType 2 =*/18).string(message.player_id);
                if (message.name != null && $Object.hasOwnProperty.call(message, "name") && message.name !== "")
                    writer.uint32(/* id 3, wireType 2 =*/26).string(message.name);
                if (message.ship_class != null && $Object.hasOwnProperty.call(message, "ship_class") && message.ship_class !== "")
                    writer.uint32(/* id 4, wireType 2 =*/34).string(message.ship_class);
                if (message.position != null && $Object.hasOwnProperty.call(message, "position"))
                    $root.galaxy.Vec3.encode(message.position, writer.uint32(/* id 5, wireType 2 =*/42).fork(), _depth + 1).ldelim();
                if (message.velocity != null && $Object.hasOwnProperty.call(message, "velocity"))
                    $root.galaxy.Vec3.encode(message.velocity, writer.uint32(/* id 6, wireType 2 =*/50).fork(), _depth + 1).ldelim();
                if (message.attitude != null && $Object.hasOwnProperty.call(message, "attitude"))
                    $root.galaxy.Quaternion.encode(message.attitude, writer.uint32(/* id 7, wireType 2 =*/58).fork(), _depth + 1).ldelim();
                if (message.angular_velocity != null && $Object.hasOwnProperty.call(message, "angular_velocity"))
                    $root.galaxy.Vec3.encode(message.angular_velocity, writer.uint32(/* id 8, wireType 2 =*/66).fork(), _depth + 1).ldelim();
                if (message.rotation_input != null && $Object.hasOwnProperty.call(message, "rotation_input"))
                    $root.galaxy.Vec3.encode(message.rotation_input, writer.uint32(/* id 9, wireType 2 =*/74).fork(), _depth + 1).ldelim();
                if (message.translation_input != null && $Object.hasOwnProperty.call(message, "translation_input"))
                    $root.galaxy.Vec3.encode(message.translation_input, writer.uint32(/* id 10, wireType 2 =*/82).fork(), _depth + 1).ldelim();
                if (message.thrust_level != null && $Object.hasOwnProperty.call(message, "thrust_level") && !$Object.is(message.thrust_level, 0))
                    writer.uint32(/* id 11, wireType 1 =*/89).double(message.thrust_level);
                if (message.attitude_hold != null && $Object.hasOwnProperty.call(message, "attitude_hold") && message.attitude_hold !== false)
                    writer.uint32(/* id 12, wireType 0 =*/96).bool(message.attitude_hold);
                if (message.attitude_mode != null && $Object.hasOwnProperty.call(message, "attitude_mode") && message.attitude_mode !== "")
                    writer.uint32(/* id 13, wireType 2 =*/106).string(message.attitude_mode);
                if (message.target_attitude != null && $Object.hasOwnProperty.call(message, "target_attitude"))
                    $root.galaxy.Quaternion.encode(message.target_attitude, writer.uint32(/* id 14, wireType 2 =*/114).fork(), _depth + 1).ldelim();
                if (message.fuel != null && $Object.hasOwnProperty.call(message, "fuel") && !$Object.is(message.fuel, 0))
                    writer.uint32(/* id 15, wireType 1 =*/121).double(message.fuel);
                if (message.mass != null && $Object.hasOwnProperty.call(message, "mass") && !$Object.is(message.mass, 0))
                    writer.uint32(/* id 16, wireType 1 =*/129).double(message.mass);
                if (message.landed_body_name != null && $Object.hasOwnProperty.call(message, "landed_body_name") && message.landed_body_name !== "")
                    writer.uint32(/* id 29, wireType 2 =*/234).string(message.landed_body_name);
                if (message.surface_contact_state != null && $Object.hasOwnProperty.call(message, "surface_contact_state") && message.surface_contact_state !== "")
                    writer.uint32(/* id 30, wireType 2 =*/242).string(message.surface_contact_state);
                if (message.contact_impact_speed != null && $Object.hasOwnProperty.call(message, "contact_impact_speed") && !$Object.is(message.contact_impact_speed, 0))
                    writer.uint32(/* id 31, wireType 1 =*/249).double(message.contact_impact_speed);
                if (message.reference_body != null && $Object.hasOwnProperty.call(message, "reference_body") && message.reference_body !== "")
                    writer.uint32(/* id 32, wireType 2 =*/258).string(message.reference_body);
                if (message.relative_position != null && $Object.hasOwnProperty.call(message, "relative_position"))
                    $root.galaxy.Vec3.encode(message.relative_position, writer.uint32(/* id 33, wireType 2 =*/266).fork(), _depth + 1).ldelim();
                if (message.relative_velocity != null && $Object.hasOwnProperty.call(message, "relative_velocity"))
                    $root.galaxy.Vec3.encode(message.relative_velocity, writer.uint32(/* id 34, wireType 2 =*/274).fork(), _depth + 1).ldelim();
                if (message.crashed != null && $Object.hasOwnProperty.call(message, "crashed") && message.crashed !== false)
                    writer.uint32(/* id 35, wireType 0 =*/280).bool(message.crashed);
                if (message.wheel_momentum != null && $Object.hasOwnProperty.call(message, "wheel_momentum"))
                    $root.galaxy.Vec3.encode(message.wheel_momentum, writer.uint32(/* id 36, wireType 2 =*/290).fork(), _depth + 1).ldelim();
                if (message.ground_contact_offset != null && $Object.hasOwnProperty.call(message, "ground_contact_offset"))
                    writer.uint32(/* id 37, wireType 1 =*/297).double(message.ground_contact_offset);
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a ShipState message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.physics.ShipState
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.physics.ShipState & galaxy.physics.ShipState.$Shape} ShipState
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            ShipState.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.physics.ShipState();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.ship_id = value;
                            else
                                delete message.ship_id;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.player_id = value;
                            else
                                delete message.player_id;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.name = value;
                            else
                                delete message.name;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.ship_class = value;
                            else
                                delete message.ship_class;
                            continue;
                        }
                    case 5: {
                            if (wireType !== 2)
                                break;
                            message.position = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.position);
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            message.velocity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.velocity);
                            continue;
                        }
                    case 7: {
                            if (wireType !== 2)
                                break;
                            message.attitude = $root.galaxy.Quaternion.decode(reader, reader.size(), $undefined, _depth + 1, message.attitude);
                            continue;
                        }
                    case 8: {
                            if (wireType !== 2)
                                break;
                            message.angular_velocity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.angular_velocity);
                            continue;
                        }
                    case 9: {
                            if (wireType !== 2)
                                break;
                            message.rotation_input = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.rotation_input);
                            continue;
                        }
                    case 10: {
                            if (wireType !== 2)
                                break;
                            message.translation_input = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.translation_input);
                            continue;
                        }
                    case 11: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.thrust_level = value;
                            else
                                delete message.thrust_level;
                            continue;
                        }
                    case 12: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.bool())
                                message.attitude_hold = value;
                            else
                                delete message.attitude_hold;
                            continue;
                        }
                    case 13: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.attitude_mode = value;
                            else
                                delete message.attitude_mode;
                            continue;
                        }
                    case 14: {
                            if (wireType !== 2)
                                break;
                            message.target_attitude = $root.galaxy.Quaternion.decode(reader, reader.size(), $undefined, _depth + 1, message.target_attitude);
                            continue;
                        }
                    case 15: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.fuel = value;
                            else
                                delete message.fuel;
                            continue;
                        }
                    case 16: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.mass = value;
                            else
                                delete message.mass;
                            continue;
                        }
                    case 29: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.landed_body_name = value;
                            else
                                delete message.landed_body_name;
                            continue;
                        }
                    case 30: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.surface_contact_state = value;
                            else
                                delete message.surface_contact_state;
                            continue;
                        }
                    case 31: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.contact_impact_speed = value;
                            else
                                delete message.contact_impact_speed;
                            continue;
                        }
                    case 32: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.reference_body = value;
                            else
                                delete message.reference_body;
                            continue;
                        }
                    case 33: {
                            if (wireType !== 2)
                                break;
                            message.relative_position = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.relative_position);
                            continue;
                        }
                    case 34: {
                            if (wireType !== 2)
                                break;
                            message.relative_velocity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.relative_velocity);
                            continue;
                        }
                    case 35: {
                            if (wireType !== 0)
                                break;
                            if (value = reader.bool())
                                message.crashed = value;
                            else
                                delete message.crashed;
                            continue;
                        }
                    case 36: {
                            if (wireType !== 2)
                                break;
                            message.wheel_momentum = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.wheel_momentum);
                            continue;
                        }
                    case 37: {
                            if (wireType !== 1)
                                break;
                            message.ground_contact_offset = reader.double();
                            message._ground_contact_offset = "ground_contact_offset";
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return ShipState;
        })();

        physics.BodyState = (function() {

            /**
             * Properties of a BodyState.
             * @typedef {Object} galaxy.physics.BodyState.$Properties
             * @property {string|null} [name] BodyState name
             * @property {number|null} [mass] BodyState mass
             * @property {number|null} [radius] BodyState radius
             * @property {galaxy.Vec3.$Properties|null} [position] BodyState position
             * @property {galaxy.Vec3.$Properties|null} [velocity] BodyState velocity
             * @property {galaxy.Quaternion.$Properties|null} [attitude] BodyState attitude
             * @property {galaxy.Vec3.$Properties|null} [angular_velocity] BodyState angular_velocity
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */

            /**
             * Properties of a BodyState.
             * @memberof galaxy.physics
             * @interface IBodyState
             * @augments galaxy.physics.BodyState.$Properties
             * @deprecated Use galaxy.physics.BodyState.$Properties instead.
             */

            /**
             * Shape of a BodyState.
             * @typedef {galaxy.physics.BodyState.$Properties} galaxy.physics.BodyState.$Shape
             */

            /**
             * Constructs a new BodyState.
             * @memberof galaxy.physics
             * @classdesc Represents a BodyState.
             * @constructor
             * @param {galaxy.physics.BodyState.$Properties=} [properties] Properties to set
             * @property {Array.<Uint8Array>} [$unknowns] Unknown fields preserved while decoding when enabled
             */
            const BodyState = function (properties) {
                if (properties)
                    for (let keys = $Object.keys(properties), i = 0; i < keys.length; ++i)
                        if (properties[keys[i]] != null && keys[i] !== "__proto__")
                            this[keys[i]] = properties[keys[i]];
            };

            /**
             * BodyState name.
             * @member {string} name
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.name = "";

            /**
             * BodyState mass.
             * @member {number} mass
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.mass = 0;

            /**
             * BodyState radius.
             * @member {number} radius
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.radius = 0;

            /**
             * BodyState position.
             * @member {galaxy.Vec3.$Properties|null|undefined} position
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.position = null;

            /**
             * BodyState velocity.
             * @member {galaxy.Vec3.$Properties|null|undefined} velocity
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.velocity = null;

            /**
             * BodyState attitude.
             * @member {galaxy.Quaternion.$Properties|null|undefined} attitude
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.attitude = null;

            /**
             * BodyState angular_velocity.
             * @member {galaxy.Vec3.$Properties|null|undefined} angular_velocity
             * @memberof galaxy.physics.BodyState
             * @instance
             */
            BodyState.prototype.angular_velocity = null;

            /**
             * Encodes the specified BodyState message. Does not implicitly {@link galaxy.physics.BodyState.verify|verify} messages.
             * @function encode
             * @memberof galaxy.physics.BodyState
             * @static
             * @param {galaxy.physics.BodyState.$Properties} message BodyState message or plain object to encode
             * @param {$protobuf.Writer} [writer] Writer to encode to
             * @returns {$protobuf.Writer} Writer
             */
            BodyState.encode = function (message, writer, _depth) {
                if (!writer)
                    writer = $Writer.create();
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $util.recursionLimit)
                    throw $Error("max depth exceeded");
                if (message.name != null && $Object.hasOwnProperty.call(message, "name") && message.name !== "")
                    writer.uint32(/* id 1, wireType 2 =*/10).string(message.name);
                if (message.mass != null && $Object.hasOwnProperty.call(message, "mass") && !$Object.is(message.mass, 0))
                    writer.uint32(/* id 2, wireType 1 =*/17).double(message.mass);
                if (message.radius != null && $Object.hasOwnProperty.call(message, "radius") && !$Object.is(message.radius, 0))
                    writer.uint32(/* id 3, wireType 1 =*/25).double(message.radius);
                if (message.position != null && $Object.hasOwnProperty.call(message, "position"))
                    $root.galaxy.Vec3.encode(message.position, writer.uint32(/* id 4, wireType 2 =*/34).fork(), _depth + 1).ldelim();
                if (message.velocity != null && $Object.hasOwnProperty.call(message, "velocity"))
                    $root.galaxy.Vec3.encode(message.velocity, writer.uint32(/* id 5, wireType 2 =*/42).fork(), _depth + 1).ldelim();
                if (message.attitude != null && $Object.hasOwnProperty.call(message, "attitude"))
                    $root.galaxy.Quaternion.encode(message.attitude, writer.uint32(/* id 6, wireType 2 =*/50).fork(), _depth + 1).ldelim();
                if (message.angular_velocity != null && $Object.hasOwnProperty.call(message, "angular_velocity"))
                    $root.galaxy.Vec3.encode(message.angular_velocity, writer.uint32(/* id 7, wireType 2 =*/58).fork(), _depth + 1).ldelim();
                if (message.$unknowns != null && $Object.hasOwnProperty.call(message, "$unknowns"))
                    for (let i = 0; i < message.$unknowns.length; ++i)
                        writer.raw(message.$unknowns[i]);
                return writer;
            };

            /**
             * Decodes a BodyState message from the specified reader or buffer.
             * @function decode
             * @memberof galaxy.physics.BodyState
             * @static
             * @param {$protobuf.Reader|Uint8Array} reader Reader or buffer to decode from
             * @param {number} [length] Message length if known beforehand
             * @returns {galaxy.physics.BodyState & galaxy.physics.BodyState.$Shape} BodyState
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            BodyState.decode = function (reader, length, _end, _depth, _target) {
                if (!(reader instanceof $Reader))
                    reader = $Reader.create(reader);
                if (_depth === $undefined)
                    _depth = 0;
                if (_depth > $Reader.recursionLimit)
                    throw $Error("max depth exceeded");
                let end, message, value;
                if (length === $undefined)
                    end = reader.len;
                else {
                    end = reader.pos + length;
                    if (end > reader.len)
                        throw $RangeError("index out of range");
                    length = reader.len;
                    reader.len = end;
                }
                message = _target || new $root.galaxy.physics.BodyState();
                while (reader.pos < end) {
                    let start = reader.pos;
                    let tag = reader.tag();
                    if (tag === _end) {
                        _end = $undefined;
                        break;
                    }
                    let wireType = tag & 7;
                    switch (tag >>>= 3) {
                    case 1: {
                            if (wireType !== 2)
                                break;
                            if ((value = reader.stringVerify()).length)
                                message.name = value;
                            else
                                delete message.name;
                            continue;
                        }
                    case 2: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.mass = value;
                            else
                                delete message.mass;
                            continue;
                        }
                    case 3: {
                            if (wireType !== 1)
                                break;
                            if (!$Object.is(value = reader.double(), 0))
                                message.radius = value;
                            else
                                delete message.radius;
                            continue;
                        }
                    case 4: {
                            if (wireType !== 2)
                                break;
                            message.position = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.position);
                            continue;
                        }
                    case 5: {
                            if (wireType !== 2)
                                break;
                            message.velocity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.velocity);
                            continue;
                        }
                    case 6: {
                            if (wireType !== 2)
                                break;
                            message.attitude = $root.galaxy.Quaternion.decode(reader, reader.size(), $undefined, _depth + 1, message.attitude);
                            continue;
                        }
                    case 7: {
                            if (wireType !== 2)
                                break;
                            message.angular_velocity = $root.galaxy.Vec3.decode(reader, reader.size(), $undefined, _depth + 1, message.angular_velocity);
                            continue;
                        }
                    }
                    reader.skipType(wireType, _depth, tag);
                    if (!reader.discardUnknown) {
                        $util.makeProp(message, "$unknowns", false);
                        (message.$unknowns || (message.$unknowns = [])).push(reader.raw(start, reader.pos));
                    }
                }
                if (length !== $undefined) {
                    if (reader.pos !== end)
                        throw $RangeError("index out of range");
                    reader.len = length;
                }
                if (_end !== $undefined)
                    throw $Error("missing end group");
                return message;
            };

            return BodyState;
        })();

        return physics;
    })();

    return galaxy;
})();

export {
  $root as default
};
