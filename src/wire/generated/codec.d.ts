import * as $protobuf from "protobufjs/minimal.js";
import Long = require("long");

/** Namespace galaxy. */
export namespace galaxy {

    /** Namespace stream. */
    namespace stream {

        /**
         * Properties of a ServerMessage.
         * @deprecated Use galaxy.stream.ServerMessage.$Properties instead.
         */
        interface IServerMessage extends galaxy.stream.ServerMessage.$Properties {
        }

        /** Represents a ServerMessage. */
        class ServerMessage {

            /**
             * Constructs a new ServerMessage.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.ServerMessage.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ServerMessage hello. */
            hello?: (galaxy.stream.Hello.$Properties|null);

            /** ServerMessage frame. */
            frame?: (galaxy.stream.ServerFrame.$Properties|null);

            /** ServerMessage pong. */
            pong?: (galaxy.stream.Pong.$Properties|null);

            /** ServerMessage message. */
            message?: ("hello"|"frame"|"pong");

            /**
             * Encodes the specified ServerMessage message. Does not implicitly {@link galaxy.stream.ServerMessage.verify|verify} messages.
             * @param message ServerMessage message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.ServerMessage.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ServerMessage message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.ServerMessage & galaxy.stream.ServerMessage.$Shape} ServerMessage
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.ServerMessage & galaxy.stream.ServerMessage.$Shape;
        }

        namespace ServerMessage {

            /** Properties of a ServerMessage. */
            interface $Properties {

                /** ServerMessage hello */
                hello?: (galaxy.stream.Hello.$Properties|null);

                /** ServerMessage frame */
                frame?: (galaxy.stream.ServerFrame.$Properties|null);

                /** ServerMessage pong */
                pong?: (galaxy.stream.Pong.$Properties|null);

                /** ServerMessage message */
                message?: ("hello"|"frame"|"pong");

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Narrowed shape of a ServerMessage. */
            type $Shape = {
              hello?: galaxy.stream.Hello.$Shape|null;
              frame?: galaxy.stream.ServerFrame.$Shape|null;
              pong?: galaxy.stream.Pong.$Shape|null;
              $unknowns?: Uint8Array[];
            } & (
              ({ message?: undefined; hello?: null; frame?: null; pong?: null }|{ message?: "hello"; hello: galaxy.stream.Hello.$Shape; frame?: null; pong?: null }|{ message?: "frame"; hello?: null; frame: galaxy.stream.ServerFrame.$Shape; pong?: null }|{ message?: "pong"; hello?: null; frame?: null; pong: galaxy.stream.Pong.$Shape })
            );
        }

        /**
         * Properties of a ClientMessage.
         * @deprecated Use galaxy.stream.ClientMessage.$Properties instead.
         */
        interface IClientMessage extends galaxy.stream.ClientMessage.$Properties {
        }

        /** Represents a ClientMessage. */
        class ClientMessage {

            /**
             * Constructs a new ClientMessage.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.ClientMessage.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ClientMessage inputs. */
            inputs?: (galaxy.stream.ClientFrame.$Properties|null);

            /** ClientMessage ping. */
            ping?: (galaxy.stream.Ping.$Properties|null);

            /** ClientMessage message. */
            message?: ("inputs"|"ping");

            /**
             * Encodes the specified ClientMessage message. Does not implicitly {@link galaxy.stream.ClientMessage.verify|verify} messages.
             * @param message ClientMessage message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.ClientMessage.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ClientMessage message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.ClientMessage & galaxy.stream.ClientMessage.$Shape} ClientMessage
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.ClientMessage & galaxy.stream.ClientMessage.$Shape;
        }

        namespace ClientMessage {

            /** Properties of a ClientMessage. */
            interface $Properties {

                /** ClientMessage inputs */
                inputs?: (galaxy.stream.ClientFrame.$Properties|null);

                /** ClientMessage ping */
                ping?: (galaxy.stream.Ping.$Properties|null);

                /** ClientMessage message */
                message?: ("inputs"|"ping");

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Narrowed shape of a ClientMessage. */
            type $Shape = {
              inputs?: galaxy.stream.ClientFrame.$Shape|null;
              ping?: galaxy.stream.Ping.$Shape|null;
              $unknowns?: Uint8Array[];
            } & (
              ({ message?: undefined; inputs?: null; ping?: null }|{ message?: "inputs"; inputs: galaxy.stream.ClientFrame.$Shape; ping?: null }|{ message?: "ping"; inputs?: null; ping: galaxy.stream.Ping.$Shape })
            );
        }

        /**
         * Properties of a Hello.
         * @deprecated Use galaxy.stream.Hello.$Properties instead.
         */
        interface IHello extends galaxy.stream.Hello.$Properties {
        }

        /** Represents a Hello. */
        class Hello {

            /**
             * Constructs a new Hello.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Hello.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Hello player_id. */
            player_id: string;

            /** Hello ship_id. */
            ship_id: string;

            /** Hello settings. */
            settings?: (galaxy.stream.Settings.$Properties|null);

            /** Hello ship_classes. */
            ship_classes: galaxy.stream.ShipClass.$Properties[];

            /** Hello bodies. */
            bodies: galaxy.physics.BodyState.$Properties[];

            /** Hello terrain. */
            terrain: string;

            /** Hello tick. */
            tick: (number|Long);

            /** Hello tick_rate. */
            tick_rate: number;

            /** Hello time_scale. */
            time_scale: number;

            /** Hello input_granularity. */
            input_granularity: string;

            /** Hello protocol_version. */
            protocol_version: string;

            /**
             * Encodes the specified Hello message. Does not implicitly {@link galaxy.stream.Hello.verify|verify} messages.
             * @param message Hello message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Hello.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a Hello message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Hello & galaxy.stream.Hello.$Shape} Hello
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Hello & galaxy.stream.Hello.$Shape;
        }

        namespace Hello {

            /** Properties of a Hello. */
            interface $Properties {

                /** Hello player_id */
                player_id?: (string|null);

                /** Hello ship_id */
                ship_id?: (string|null);

                /** Hello settings */
                settings?: (galaxy.stream.Settings.$Properties|null);

                /** Hello ship_classes */
                ship_classes?: (galaxy.stream.ShipClass.$Properties[]|null);

                /** Hello bodies */
                bodies?: (galaxy.physics.BodyState.$Properties[]|null);

                /** Hello terrain */
                terrain?: (string|null);

                /** Hello tick */
                tick?: (number|Long|null);

                /** Hello tick_rate */
                tick_rate?: (number|null);

                /** Hello time_scale */
                time_scale?: (number|null);

                /** Hello input_granularity */
                input_granularity?: (string|null);

                /** Hello protocol_version */
                protocol_version?: (string|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a Hello. */
            type $Shape = galaxy.stream.Hello.$Properties;
        }

        /**
         * Properties of a Settings.
         * @deprecated Use galaxy.stream.Settings.$Properties instead.
         */
        interface ISettings extends galaxy.stream.Settings.$Properties {
        }

        /** Represents a Settings. */
        class Settings {

            /**
             * Constructs a new Settings.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Settings.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Settings contact_crash_speed. */
            contact_crash_speed?: (number|null);

            /** Settings contact_bounce_speed. */
            contact_bounce_speed?: (number|null);

            /** Settings contact_settle_tilt_deg. */
            contact_settle_tilt_deg?: (number|null);

            /** Settings contact_settle_angular_vel. */
            contact_settle_angular_vel?: (number|null);

            /** Settings contact_settle_linear_vel. */
            contact_settle_linear_vel?: (number|null);

            /** Settings contact_tipped_angle_deg. */
            contact_tipped_angle_deg?: (number|null);

            /** Settings contact_damping_ratio. */
            contact_damping_ratio?: (number|null);

            /** Settings contact_friction_static. */
            contact_friction_static?: (number|null);

            /** Settings contact_friction_kinetic. */
            contact_friction_kinetic?: (number|null);

            /** Settings touchdown_attitude. */
            touchdown_attitude?: (string|null);

            /** Settings surface_normal. */
            surface_normal?: (string|null);

            /** Settings contact_longest_substep. */
            contact_longest_substep?: (number|null);

            /**
             * Encodes the specified Settings message. Does not implicitly {@link galaxy.stream.Settings.verify|verify} messages.
             * @param message Settings message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Settings.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a Settings message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Settings & galaxy.stream.Settings.$Shape} Settings
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Settings & galaxy.stream.Settings.$Shape;
        }

        namespace Settings {

            /** Properties of a Settings. */
            interface $Properties {

                /** Settings contact_crash_speed */
                contact_crash_speed?: (number|null);

                /** Settings contact_bounce_speed */
                contact_bounce_speed?: (number|null);

                /** Settings contact_settle_tilt_deg */
                contact_settle_tilt_deg?: (number|null);

                /** Settings contact_settle_angular_vel */
                contact_settle_angular_vel?: (number|null);

                /** Settings contact_settle_linear_vel */
                contact_settle_linear_vel?: (number|null);

                /** Settings contact_tipped_angle_deg */
                contact_tipped_angle_deg?: (number|null);

                /** Settings contact_damping_ratio */
                contact_damping_ratio?: (number|null);

                /** Settings contact_friction_static */
                contact_friction_static?: (number|null);

                /** Settings contact_friction_kinetic */
                contact_friction_kinetic?: (number|null);

                /** Settings touchdown_attitude */
                touchdown_attitude?: (string|null);

                /** Settings surface_normal */
                surface_normal?: (string|null);

                /** Settings contact_longest_substep */
                contact_longest_substep?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a Settings. */
            type $Shape = galaxy.stream.Settings.$Properties;
        }

        /**
         * Properties of a ShipClass.
         * @deprecated Use galaxy.stream.ShipClass.$Properties instead.
         */
        interface IShipClass extends galaxy.stream.ShipClass.$Properties {
        }

        /** Represents a ShipClass. */
        class ShipClass {

            /**
             * Constructs a new ShipClass.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.ShipClass.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ShipClass name. */
            name: string;

            /** ShipClass dry_mass. */
            dry_mass: number;

            /** ShipClass fuel_capacity. */
            fuel_capacity: number;

            /** ShipClass inertia_tensor. */
            inertia_tensor?: (galaxy.stream.InertiaTensor.$Properties|null);

            /** ShipClass ground_contact_offset. */
            ground_contact_offset: number;

            /** ShipClass leg_radius. */
            leg_radius: number;

            /** ShipClass main_engine_thrust. */
            main_engine_thrust: number;

            /** ShipClass main_engine_isp. */
            main_engine_isp: number;

            /** ShipClass rcs_thrust. */
            rcs_thrust?: (galaxy.Vec3.$Properties|null);

            /** ShipClass rcs_torque. */
            rcs_torque?: (galaxy.Vec3.$Properties|null);

            /** ShipClass rcs_lever. */
            rcs_lever: number;

            /** ShipClass rcs_isp. */
            rcs_isp: number;

            /** ShipClass reaction_wheel_torque. */
            reaction_wheel_torque?: (galaxy.Vec3.$Properties|null);

            /** ShipClass reaction_wheel_capacity. */
            reaction_wheel_capacity?: (galaxy.Vec3.$Properties|null);

            /** ShipClass attitude_natural_frequency. */
            attitude_natural_frequency: number;

            /** ShipClass dry_inertia_ratio. */
            dry_inertia_ratio?: (number|null);

            /**
             * Encodes the specified ShipClass message. Does not implicitly {@link galaxy.stream.ShipClass.verify|verify} messages.
             * @param message ShipClass message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.ShipClass.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ShipClass message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.ShipClass & galaxy.stream.ShipClass.$Shape} ShipClass
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.ShipClass & galaxy.stream.ShipClass.$Shape;
        }

        namespace ShipClass {

            /** Properties of a ShipClass. */
            interface $Properties {

                /** ShipClass name */
                name?: (string|null);

                /** ShipClass dry_mass */
                dry_mass?: (number|null);

                /** ShipClass fuel_capacity */
                fuel_capacity?: (number|null);

                /** ShipClass inertia_tensor */
                inertia_tensor?: (galaxy.stream.InertiaTensor.$Properties|null);

                /** ShipClass ground_contact_offset */
                ground_contact_offset?: (number|null);

                /** ShipClass leg_radius */
                leg_radius?: (number|null);

                /** ShipClass main_engine_thrust */
                main_engine_thrust?: (number|null);

                /** ShipClass main_engine_isp */
                main_engine_isp?: (number|null);

                /** ShipClass rcs_thrust */
                rcs_thrust?: (galaxy.Vec3.$Properties|null);

                /** ShipClass rcs_torque */
                rcs_torque?: (galaxy.Vec3.$Properties|null);

                /** ShipClass rcs_lever */
                rcs_lever?: (number|null);

                /** ShipClass rcs_isp */
                rcs_isp?: (number|null);

                /** ShipClass reaction_wheel_torque */
                reaction_wheel_torque?: (galaxy.Vec3.$Properties|null);

                /** ShipClass reaction_wheel_capacity */
                reaction_wheel_capacity?: (galaxy.Vec3.$Properties|null);

                /** ShipClass attitude_natural_frequency */
                attitude_natural_frequency?: (number|null);

                /** ShipClass dry_inertia_ratio */
                dry_inertia_ratio?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a ShipClass. */
            type $Shape = galaxy.stream.ShipClass.$Properties;
        }

        /**
         * Properties of an InertiaTensor.
         * @deprecated Use galaxy.stream.InertiaTensor.$Properties instead.
         */
        interface IInertiaTensor extends galaxy.stream.InertiaTensor.$Properties {
        }

        /** Represents an InertiaTensor. */
        class InertiaTensor {

            /**
             * Constructs a new InertiaTensor.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.InertiaTensor.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** InertiaTensor x. */
            x?: (galaxy.Vec3.$Properties|null);

            /** InertiaTensor y. */
            y?: (galaxy.Vec3.$Properties|null);

            /** InertiaTensor z. */
            z?: (galaxy.Vec3.$Properties|null);

            /**
             * Encodes the specified InertiaTensor message. Does not implicitly {@link galaxy.stream.InertiaTensor.verify|verify} messages.
             * @param message InertiaTensor message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.InertiaTensor.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes an InertiaTensor message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.InertiaTensor & galaxy.stream.InertiaTensor.$Shape} InertiaTensor
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.InertiaTensor & galaxy.stream.InertiaTensor.$Shape;
        }

        namespace InertiaTensor {

            /** Properties of an InertiaTensor. */
            interface $Properties {

                /** InertiaTensor x */
                x?: (galaxy.Vec3.$Properties|null);

                /** InertiaTensor y */
                y?: (galaxy.Vec3.$Properties|null);

                /** InertiaTensor z */
                z?: (galaxy.Vec3.$Properties|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of an InertiaTensor. */
            type $Shape = galaxy.stream.InertiaTensor.$Properties;
        }

        /**
         * Properties of a ServerFrame.
         * @deprecated Use galaxy.stream.ServerFrame.$Properties instead.
         */
        interface IServerFrame extends galaxy.stream.ServerFrame.$Properties {
        }

        /** Represents a ServerFrame. */
        class ServerFrame {

            /**
             * Constructs a new ServerFrame.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.ServerFrame.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ServerFrame tick. */
            tick: (number|Long);

            /** ServerFrame tick_rate. */
            tick_rate: number;

            /** ServerFrame time_scale. */
            time_scale: number;

            /** ServerFrame paused. */
            paused: boolean;

            /** ServerFrame bodies. */
            bodies: galaxy.physics.BodyState.$Properties[];

            /** ServerFrame ships. */
            ships: galaxy.physics.ShipState.$Properties[];

            /** ServerFrame events. */
            events: galaxy.stream.Event.$Properties[];

            /** ServerFrame last_input. */
            last_input?: (galaxy.stream.InputAcknowledgement.$Properties|null);

            /** ServerFrame game_time. */
            game_time?: (number|null);

            /**
             * Encodes the specified ServerFrame message. Does not implicitly {@link galaxy.stream.ServerFrame.verify|verify} messages.
             * @param message ServerFrame message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.ServerFrame.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ServerFrame message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.ServerFrame & galaxy.stream.ServerFrame.$Shape} ServerFrame
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.ServerFrame & galaxy.stream.ServerFrame.$Shape;
        }

        namespace ServerFrame {

            /** Properties of a ServerFrame. */
            interface $Properties {

                /** ServerFrame tick */
                tick?: (number|Long|null);

                /** ServerFrame tick_rate */
                tick_rate?: (number|null);

                /** ServerFrame time_scale */
                time_scale?: (number|null);

                /** ServerFrame paused */
                paused?: (boolean|null);

                /** ServerFrame bodies */
                bodies?: (galaxy.physics.BodyState.$Properties[]|null);

                /** ServerFrame ships */
                ships?: (galaxy.physics.ShipState.$Properties[]|null);

                /** ServerFrame events */
                events?: (galaxy.stream.Event.$Properties[]|null);

                /** ServerFrame last_input */
                last_input?: (galaxy.stream.InputAcknowledgement.$Properties|null);

                /** ServerFrame game_time */
                game_time?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a ServerFrame. */
            type $Shape = galaxy.stream.ServerFrame.$Properties;
        }

        /**
         * Properties of an Event.
         * @deprecated Use galaxy.stream.Event.$Properties instead.
         */
        interface IEvent extends galaxy.stream.Event.$Properties {
        }

        /** Represents an Event. */
        class Event {

            /**
             * Constructs a new Event.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Event.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Event type. */
            type: string;

            /** Event ship_id. */
            ship_id: string;

            /** Event tick. */
            tick: (number|Long);

            /** Event substep. */
            substep?: (number|null);

            /** Event again. */
            again: boolean;

            /** Event player_id. */
            player_id: string;

            /** Event body. */
            body: string;

            /** Event reason. */
            reason: string;

            /**
             * Encodes the specified Event message. Does not implicitly {@link galaxy.stream.Event.verify|verify} messages.
             * @param message Event message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Event.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes an Event message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Event & galaxy.stream.Event.$Shape} Event
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Event & galaxy.stream.Event.$Shape;
        }

        namespace Event {

            /** Properties of an Event. */
            interface $Properties {

                /** Event type */
                type?: (string|null);

                /** Event ship_id */
                ship_id?: (string|null);

                /** Event tick */
                tick?: (number|Long|null);

                /** Event substep */
                substep?: (number|null);

                /** Event again */
                again?: (boolean|null);

                /** Event player_id */
                player_id?: (string|null);

                /** Event body */
                body?: (string|null);

                /** Event reason */
                reason?: (string|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of an Event. */
            type $Shape = galaxy.stream.Event.$Properties;
        }

        /**
         * Properties of an InputAcknowledgement.
         * @deprecated Use galaxy.stream.InputAcknowledgement.$Properties instead.
         */
        interface IInputAcknowledgement extends galaxy.stream.InputAcknowledgement.$Properties {
        }

        /** Represents an InputAcknowledgement. */
        class InputAcknowledgement {

            /**
             * Constructs a new InputAcknowledgement.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.InputAcknowledgement.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** InputAcknowledgement seq. */
            seq: (number|Long);

            /** InputAcknowledgement tick. */
            tick: (number|Long);

            /** InputAcknowledgement substep. */
            substep: number;

            /** InputAcknowledgement margin. */
            margin: number;

            /**
             * Encodes the specified InputAcknowledgement message. Does not implicitly {@link galaxy.stream.InputAcknowledgement.verify|verify} messages.
             * @param message InputAcknowledgement message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.InputAcknowledgement.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes an InputAcknowledgement message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.InputAcknowledgement & galaxy.stream.InputAcknowledgement.$Shape} InputAcknowledgement
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.InputAcknowledgement & galaxy.stream.InputAcknowledgement.$Shape;
        }

        namespace InputAcknowledgement {

            /** Properties of an InputAcknowledgement. */
            interface $Properties {

                /** InputAcknowledgement seq */
                seq?: (number|Long|null);

                /** InputAcknowledgement tick */
                tick?: (number|Long|null);

                /** InputAcknowledgement substep */
                substep?: (number|null);

                /** InputAcknowledgement margin */
                margin?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of an InputAcknowledgement. */
            type $Shape = galaxy.stream.InputAcknowledgement.$Properties;
        }

        /**
         * Properties of a Pong.
         * @deprecated Use galaxy.stream.Pong.$Properties instead.
         */
        interface IPong extends galaxy.stream.Pong.$Properties {
        }

        /** Represents a Pong. */
        class Pong {

            /**
             * Constructs a new Pong.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Pong.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Pong id. */
            id: (number|Long);

            /** Pong tick. */
            tick: (number|Long);

            /** Pong since_tick. */
            since_tick: number;

            /**
             * Encodes the specified Pong message. Does not implicitly {@link galaxy.stream.Pong.verify|verify} messages.
             * @param message Pong message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Pong.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a Pong message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Pong & galaxy.stream.Pong.$Shape} Pong
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Pong & galaxy.stream.Pong.$Shape;
        }

        namespace Pong {

            /** Properties of a Pong. */
            interface $Properties {

                /** Pong id */
                id?: (number|Long|null);

                /** Pong tick */
                tick?: (number|Long|null);

                /** Pong since_tick */
                since_tick?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a Pong. */
            type $Shape = galaxy.stream.Pong.$Properties;
        }

        /**
         * Properties of a ClientFrame.
         * @deprecated Use galaxy.stream.ClientFrame.$Properties instead.
         */
        interface IClientFrame extends galaxy.stream.ClientFrame.$Properties {
        }

        /** Represents a ClientFrame. */
        class ClientFrame {

            /**
             * Constructs a new ClientFrame.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.ClientFrame.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ClientFrame inputs. */
            inputs: galaxy.stream.Input.$Properties[];

            /**
             * Encodes the specified ClientFrame message. Does not implicitly {@link galaxy.stream.ClientFrame.verify|verify} messages.
             * @param message ClientFrame message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.ClientFrame.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ClientFrame message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.ClientFrame & galaxy.stream.ClientFrame.$Shape} ClientFrame
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.ClientFrame & galaxy.stream.ClientFrame.$Shape;
        }

        namespace ClientFrame {

            /** Properties of a ClientFrame. */
            interface $Properties {

                /** ClientFrame inputs */
                inputs?: (galaxy.stream.Input.$Properties[]|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a ClientFrame. */
            type $Shape = galaxy.stream.ClientFrame.$Properties;
        }

        /**
         * Properties of an Input.
         * @deprecated Use galaxy.stream.Input.$Properties instead.
         */
        interface IInput extends galaxy.stream.Input.$Properties {
        }

        /** Represents an Input. */
        class Input {

            /**
             * Constructs a new Input.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Input.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Input seq. */
            seq: (number|Long);

            /** Input tick. */
            tick: (number|Long);

            /** Input substep. */
            substep: number;

            /** Input controls. */
            controls?: (galaxy.stream.Controls.$Properties|null);

            /**
             * Encodes the specified Input message. Does not implicitly {@link galaxy.stream.Input.verify|verify} messages.
             * @param message Input message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Input.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes an Input message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Input & galaxy.stream.Input.$Shape} Input
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Input & galaxy.stream.Input.$Shape;
        }

        namespace Input {

            /** Properties of an Input. */
            interface $Properties {

                /** Input seq */
                seq?: (number|Long|null);

                /** Input tick */
                tick?: (number|Long|null);

                /** Input substep */
                substep?: (number|null);

                /** Input controls */
                controls?: (galaxy.stream.Controls.$Properties|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of an Input. */
            type $Shape = galaxy.stream.Input.$Properties;
        }

        /**
         * Properties of a Controls.
         * @deprecated Use galaxy.stream.Controls.$Properties instead.
         */
        interface IControls extends galaxy.stream.Controls.$Properties {
        }

        /** Represents a Controls. */
        class Controls {

            /**
             * Constructs a new Controls.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Controls.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Controls thrust_level. */
            thrust_level: number;

            /** Controls translation_input. */
            translation_input?: (galaxy.Vec3.$Properties|null);

            /** Controls rotation_input. */
            rotation_input?: (galaxy.Vec3.$Properties|null);

            /** Controls attitude_hold. */
            attitude_hold: boolean;

            /** Controls attitude_mode. */
            attitude_mode: string;

            /** Controls target_attitude. */
            target_attitude?: (galaxy.Quaternion.$Properties|null);

            /**
             * Encodes the specified Controls message. Does not implicitly {@link galaxy.stream.Controls.verify|verify} messages.
             * @param message Controls message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Controls.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a Controls message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Controls & galaxy.stream.Controls.$Shape} Controls
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Controls & galaxy.stream.Controls.$Shape;
        }

        namespace Controls {

            /** Properties of a Controls. */
            interface $Properties {

                /** Controls thrust_level */
                thrust_level?: (number|null);

                /** Controls translation_input */
                translation_input?: (galaxy.Vec3.$Properties|null);

                /** Controls rotation_input */
                rotation_input?: (galaxy.Vec3.$Properties|null);

                /** Controls attitude_hold */
                attitude_hold?: (boolean|null);

                /** Controls attitude_mode */
                attitude_mode?: (string|null);

                /** Controls target_attitude */
                target_attitude?: (galaxy.Quaternion.$Properties|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a Controls. */
            type $Shape = galaxy.stream.Controls.$Properties;
        }

        /**
         * Properties of a Ping.
         * @deprecated Use galaxy.stream.Ping.$Properties instead.
         */
        interface IPing extends galaxy.stream.Ping.$Properties {
        }

        /** Represents a Ping. */
        class Ping {

            /**
             * Constructs a new Ping.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.stream.Ping.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** Ping id. */
            id: (number|Long);

            /**
             * Encodes the specified Ping message. Does not implicitly {@link galaxy.stream.Ping.verify|verify} messages.
             * @param message Ping message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.stream.Ping.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a Ping message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.stream.Ping & galaxy.stream.Ping.$Shape} Ping
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.stream.Ping & galaxy.stream.Ping.$Shape;
        }

        namespace Ping {

            /** Properties of a Ping. */
            interface $Properties {

                /** Ping id */
                id?: (number|Long|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a Ping. */
            type $Shape = galaxy.stream.Ping.$Properties;
        }
    }

    /**
     * Properties of a Vec3.
     * @deprecated Use galaxy.Vec3.$Properties instead.
     */
    interface IVec3 extends galaxy.Vec3.$Properties {
    }

    /** Represents a Vec3. */
    class Vec3 {

        /**
         * Constructs a new Vec3.
         * @param [properties] Properties to set
         */
        constructor(properties?: galaxy.Vec3.$Properties);

        /** Unknown fields preserved while decoding when enabled */
        $unknowns?: Uint8Array[];

        /** Vec3 x. */
        x: number;

        /** Vec3 y. */
        y: number;

        /** Vec3 z. */
        z: number;

        /**
         * Encodes the specified Vec3 message. Does not implicitly {@link galaxy.Vec3.verify|verify} messages.
         * @param message Vec3 message or plain object to encode
         * @param [writer] Writer to encode to
         * @returns Writer
         */
        static encode(message: galaxy.Vec3.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

        /**
         * Decodes a Vec3 message from the specified reader or buffer.
         * @param reader Reader or buffer to decode from
         * @param [length] Message length if known beforehand
         * @returns {galaxy.Vec3 & galaxy.Vec3.$Shape} Vec3
         * @throws {Error} If the payload is not a reader or valid buffer
         * @throws {$protobuf.util.ProtocolError} If required fields are missing
         */
        static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.Vec3 & galaxy.Vec3.$Shape;
    }

    namespace Vec3 {

        /** Properties of a Vec3. */
        interface $Properties {

            /** Vec3 x */
            x?: (number|null);

            /** Vec3 y */
            y?: (number|null);

            /** Vec3 z */
            z?: (number|null);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];
        }

        /** Shape of a Vec3. */
        type $Shape = galaxy.Vec3.$Properties;
    }

    /**
     * Properties of a Quaternion.
     * @deprecated Use galaxy.Quaternion.$Properties instead.
     */
    interface IQuaternion extends galaxy.Quaternion.$Properties {
    }

    /** Represents a Quaternion. */
    class Quaternion {

        /**
         * Constructs a new Quaternion.
         * @param [properties] Properties to set
         */
        constructor(properties?: galaxy.Quaternion.$Properties);

        /** Unknown fields preserved while decoding when enabled */
        $unknowns?: Uint8Array[];

        /** Quaternion w. */
        w: number;

        /** Quaternion x. */
        x: number;

        /** Quaternion y. */
        y: number;

        /** Quaternion z. */
        z: number;

        /**
         * Encodes the specified Quaternion message. Does not implicitly {@link galaxy.Quaternion.verify|verify} messages.
         * @param message Quaternion message or plain object to encode
         * @param [writer] Writer to encode to
         * @returns Writer
         */
        static encode(message: galaxy.Quaternion.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

        /**
         * Decodes a Quaternion message from the specified reader or buffer.
         * @param reader Reader or buffer to decode from
         * @param [length] Message length if known beforehand
         * @returns {galaxy.Quaternion & galaxy.Quaternion.$Shape} Quaternion
         * @throws {Error} If the payload is not a reader or valid buffer
         * @throws {$protobuf.util.ProtocolError} If required fields are missing
         */
        static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.Quaternion & galaxy.Quaternion.$Shape;
    }

    namespace Quaternion {

        /** Properties of a Quaternion. */
        interface $Properties {

            /** Quaternion w */
            w?: (number|null);

            /** Quaternion x */
            x?: (number|null);

            /** Quaternion y */
            y?: (number|null);

            /** Quaternion z */
            z?: (number|null);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];
        }

        /** Shape of a Quaternion. */
        type $Shape = galaxy.Quaternion.$Properties;
    }

    /** Namespace physics. */
    namespace physics {

        /**
         * Properties of a ShipState.
         * @deprecated Use galaxy.physics.ShipState.$Properties instead.
         */
        interface IShipState extends galaxy.physics.ShipState.$Properties {
        }

        /** Represents a ShipState. */
        class ShipState {

            /**
             * Constructs a new ShipState.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.physics.ShipState.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** ShipState ship_id. */
            ship_id: string;

            /** ShipState player_id. */
            player_id: string;

            /** ShipState name. */
            name: string;

            /** ShipState ship_class. */
            ship_class: string;

            /** ShipState position. */
            position?: (galaxy.Vec3.$Properties|null);

            /** ShipState velocity. */
            velocity?: (galaxy.Vec3.$Properties|null);

            /** ShipState attitude. */
            attitude?: (galaxy.Quaternion.$Properties|null);

            /** ShipState angular_velocity. */
            angular_velocity?: (galaxy.Vec3.$Properties|null);

            /** ShipState rotation_input. */
            rotation_input?: (galaxy.Vec3.$Properties|null);

            /** ShipState translation_input. */
            translation_input?: (galaxy.Vec3.$Properties|null);

            /** ShipState thrust_level. */
            thrust_level: number;

            /** ShipState attitude_hold. */
            attitude_hold: boolean;

            /** ShipState attitude_mode. */
            attitude_mode: string;

            /** ShipState target_attitude. */
            target_attitude?: (galaxy.Quaternion.$Properties|null);

            /** ShipState fuel. */
            fuel: number;

            /** ShipState mass. */
            mass: number;

            /** ShipState landed_body_name. */
            landed_body_name: string;

            /** ShipState surface_contact_state. */
            surface_contact_state: string;

            /** ShipState contact_impact_speed. */
            contact_impact_speed: number;

            /** ShipState reference_body. */
            reference_body: string;

            /** ShipState relative_position. */
            relative_position?: (galaxy.Vec3.$Properties|null);

            /** ShipState relative_velocity. */
            relative_velocity?: (galaxy.Vec3.$Properties|null);

            /** ShipState crashed. */
            crashed: boolean;

            /** ShipState wheel_momentum. */
            wheel_momentum?: (galaxy.Vec3.$Properties|null);

            /** ShipState ground_contact_offset. */
            ground_contact_offset?: (number|null);

            /**
             * Encodes the specified ShipState message. Does not implicitly {@link galaxy.physics.ShipState.verify|verify} messages.
             * @param message ShipState message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.physics.ShipState.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a ShipState message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.physics.ShipState & galaxy.physics.ShipState.$Shape} ShipState
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.physics.ShipState & galaxy.physics.ShipState.$Shape;
        }

        namespace ShipState {

            /** Properties of a ShipState. */
            interface $Properties {

                /** ShipState ship_id */
                ship_id?: (string|null);

                /** ShipState player_id */
                player_id?: (string|null);

                /** ShipState name */
                name?: (string|null);

                /** ShipState ship_class */
                ship_class?: (string|null);

                /** ShipState position */
                position?: (galaxy.Vec3.$Properties|null);

                /** ShipState velocity */
                velocity?: (galaxy.Vec3.$Properties|null);

                /** ShipState attitude */
                attitude?: (galaxy.Quaternion.$Properties|null);

                /** ShipState angular_velocity */
                angular_velocity?: (galaxy.Vec3.$Properties|null);

                /** ShipState rotation_input */
                rotation_input?: (galaxy.Vec3.$Properties|null);

                /** ShipState translation_input */
                translation_input?: (galaxy.Vec3.$Properties|null);

                /** ShipState thrust_level */
                thrust_level?: (number|null);

                /** ShipState attitude_hold */
                attitude_hold?: (boolean|null);

                /** ShipState attitude_mode */
                attitude_mode?: (string|null);

                /** ShipState target_attitude */
                target_attitude?: (galaxy.Quaternion.$Properties|null);

                /** ShipState fuel */
                fuel?: (number|null);

                /** ShipState mass */
                mass?: (number|null);

                /** ShipState landed_body_name */
                landed_body_name?: (string|null);

                /** ShipState surface_contact_state */
                surface_contact_state?: (string|null);

                /** ShipState contact_impact_speed */
                contact_impact_speed?: (number|null);

                /** ShipState reference_body */
                reference_body?: (string|null);

                /** ShipState relative_position */
                relative_position?: (galaxy.Vec3.$Properties|null);

                /** ShipState relative_velocity */
                relative_velocity?: (galaxy.Vec3.$Properties|null);

                /** ShipState crashed */
                crashed?: (boolean|null);

                /** ShipState wheel_momentum */
                wheel_momentum?: (galaxy.Vec3.$Properties|null);

                /** ShipState ground_contact_offset */
                ground_contact_offset?: (number|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a ShipState. */
            type $Shape = galaxy.physics.ShipState.$Properties;
        }

        /**
         * Properties of a BodyState.
         * @deprecated Use galaxy.physics.BodyState.$Properties instead.
         */
        interface IBodyState extends galaxy.physics.BodyState.$Properties {
        }

        /** Represents a BodyState. */
        class BodyState {

            /**
             * Constructs a new BodyState.
             * @param [properties] Properties to set
             */
            constructor(properties?: galaxy.physics.BodyState.$Properties);

            /** Unknown fields preserved while decoding when enabled */
            $unknowns?: Uint8Array[];

            /** BodyState name. */
            name: string;

            /** BodyState mass. */
            mass: number;

            /** BodyState radius. */
            radius: number;

            /** BodyState position. */
            position?: (galaxy.Vec3.$Properties|null);

            /** BodyState velocity. */
            velocity?: (galaxy.Vec3.$Properties|null);

            /** BodyState attitude. */
            attitude?: (galaxy.Quaternion.$Properties|null);

            /** BodyState angular_velocity. */
            angular_velocity?: (galaxy.Vec3.$Properties|null);

            /**
             * Encodes the specified BodyState message. Does not implicitly {@link galaxy.physics.BodyState.verify|verify} messages.
             * @param message BodyState message or plain object to encode
             * @param [writer] Writer to encode to
             * @returns Writer
             */
            static encode(message: galaxy.physics.BodyState.$Properties, writer?: $protobuf.Writer): $protobuf.Writer;

            /**
             * Decodes a BodyState message from the specified reader or buffer.
             * @param reader Reader or buffer to decode from
             * @param [length] Message length if known beforehand
             * @returns {galaxy.physics.BodyState & galaxy.physics.BodyState.$Shape} BodyState
             * @throws {Error} If the payload is not a reader or valid buffer
             * @throws {$protobuf.util.ProtocolError} If required fields are missing
             */
            static decode(reader: ($protobuf.Reader|Uint8Array), length?: number): galaxy.physics.BodyState & galaxy.physics.BodyState.$Shape;
        }

        namespace BodyState {

            /** Properties of a BodyState. */
            interface $Properties {

                /** BodyState name */
                name?: (string|null);

                /** BodyState mass */
                mass?: (number|null);

                /** BodyState radius */
                radius?: (number|null);

                /** BodyState position */
                position?: (galaxy.Vec3.$Properties|null);

                /** BodyState velocity */
                velocity?: (galaxy.Vec3.$Properties|null);

                /** BodyState attitude */
                attitude?: (galaxy.Quaternion.$Properties|null);

                /** BodyState angular_velocity */
                angular_velocity?: (galaxy.Vec3.$Properties|null);

                /** Unknown fields preserved while decoding when enabled */
                $unknowns?: Uint8Array[];
            }

            /** Shape of a BodyState. */
            type $Shape = galaxy.physics.BodyState.$Properties;
        }
    }
}
