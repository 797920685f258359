"use strict";(()=>{var Qx=["idle","running","success","failure","skipped"],Lm=i=>Qx[i??0]??"idle",js=(i,e)=>i[e];function bl(i){let e=js(i,"transition_node"),t=js(i,"transition_to"),n=js(i,"status").map(Lm),s=js(i,"transition_time").map((r,o)=>({time_s:r,node:e[o]??-1,to:Lm(t[o])}));return{state:String(i.state),mission:String(i.mission),text:String(i.text),ticks:Number(i.ticks),revision:Number(i.revision),node_count:n.length,status:n,transitions:Number(i.transitions),newest:s}}function km(i){return{revision:Number(i.revision),parent:js(i,"parent"),type:js(i,"type"),name:js(i,"name")}}var wl=i=>({commander:String(i.commander),reason:String(i.reason),text:String(i.text)}),eb={person_stops:"a person has stopped the robot",person_is_lost:"the person who commanded is lost",person_moves_joint:"a person moves a joint"};function Dm(i,e){let t=e&&["runs","halts","waits"].includes(e.state)?e.mission:"";if(!i||t===""&&i.commander!=="behaviour")return;let n=i.text;switch(i.commander){case"behaviour":return{text:`the behaviour commands${t===""?"":`: ${t}`}`,why:n,lets_go:!1};case"person":return{text:`${eb[i.reason]??"a person commands"}, ${t} waits`,why:n,lets_go:!0};case"emergency_stop":return{text:`emergency stop, ${t} waits`,why:n,lets_go:!1};default:return}}function A(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r===void 0||r===!1||n.setAttribute(s,r===!0?"":String(r));return n.append(...t),n}function ke(i,e,t={}){let n=A("button",{type:"button",...t},i);return n.addEventListener("click",e),n}function tt(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element '${i}'`);return e}function he(i,e){i.textContent!==e&&(i.textContent=e)}function Ml(...i){return A("tr",{},...i.map(e=>A("td",{},e)))}function Oi(i,...e){let t=A("tbody"),n=A("thead",{},A("tr",{},...e.map(s=>A("th",{scope:"col"},s))));return{table:A("table",{},A("caption",{},i),n,t),body:t}}function Js(i){return i instanceof HTMLElement&&(i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)||i instanceof HTMLInputElement&&!/^(checkbox|radio|button)$/.test(i.type))}var Sl=class{frame;came_ms=-1/0;connected=!1;outageSince_ms;pace=1;loss={frames:0,outages:0,longest_ms:0};take(e,t){this.endOutage(t);let n=this.frame?(e.frame[0]??0)-(this.frame.frame[0]??0)-1:0;this.connected&&n>0&&(this.loss.frames+=n),this.connected=!0,this.frame=e,this.came_ms=t}disconnected(e){this.connected&&this.beginOutage(e),this.connected=!1}get newest(){return this.frame}age_ms(e,t){if(!this.frame)return 1/0;if(this.rests)return this.sinceCame_ms(t);let n=(this.frame.age[e]??NaN)*1e3,s=(this.frame.round_trip[0]??NaN)*1e3/2;return Number.isNaN(n)?1/0:n*Math.min(this.pace,1)+(Number.isNaN(s)?0:s)+this.sinceCame_ms(t)}get rests(){return this.pace===0}sinceCame_ms(e){return e-this.came_ms}pictureAge_ms(e){return Math.max(...[0,1,2,4].map(t=>this.age_ms(t,e)))}state(e){return!this.connected||this.sinceCame_ms(e)>1e3?"lost":this.pictureAge_ms(e)>300?"old":"live"}beginOutage(e){this.outageSince_ms??=Math.min(e,Math.max(this.came_ms,0))}endOutage(e){this.frame&&this.sinceCame_ms(e)>1e3&&this.beginOutage(e),this.outageSince_ms!==void 0&&(this.loss.outages+=1,this.loss.longest_ms=Math.max(this.loss.longest_ms,e-this.outageSince_ms),this.outageSince_ms=void 0)}};function Nn(i){return Number.isFinite(i)?i<1e3?`${Math.max(Math.round(i),0)} ms`:i<6e4?`${(i/1e3).toFixed(1)} s`:`${Math.round(i/6e4)} min`:"never"}var pd=[{name:"version",type:"uint8",count:1,scale:1},{name:"joint_count",type:"uint8",count:1,scale:1},{name:"frame",type:"uint32",count:1,scale:0},{name:"robot_time",type:"uint32",count:1,scale:.001},{name:"mode",type:"uint8",count:1,scale:1},{name:"activity",type:"uint8",count:1,scale:1},{name:"contact",type:"uint8",count:2,scale:1},{name:"age",type:"uint16",count:5,scale:.001},{name:"round_trip",type:"uint16",count:1,scale:.001},{name:"base_place",type:"int32",count:2,scale:1e-4},{name:"base_height",type:"int16",count:1,scale:1e-4},{name:"base_turn",type:"int16",count:4,scale:3051850947599719e-20},{name:"com",type:"int16",count:3,scale:1e-4},{name:"zmp",type:"int16",count:2,scale:1e-4},{name:"planned_zmp",type:"int16",count:2,scale:1e-4},{name:"foot_force",type:"uint16",count:2,scale:.1},{name:"velocity",type:"int16",count:3,scale:.001},{name:"joint_trouble",type:"uint8",count:5,scale:0},{name:"batches_late",type:"uint16",count:1,scale:0},{name:"batches_refused",type:"uint16",count:1,scale:0},{name:"tails_played",type:"uint16",count:1,scale:0},{name:"footstep_count",type:"uint8",count:1,scale:1},{name:"footstep",type:"int16",count:12,scale:.001},{name:"commander",type:"uint8",count:16,scale:0},{name:"joint",type:"int16",count:0,scale:1e-4}];var Um={uint8:1,int16:2,uint16:2,int32:4,uint32:4},tb={uint8:255,int16:-32768,uint16:65535,int32:-2147483648,uint32:4294967295},jo=class extends Error{};function nb(i,e,t){switch(e){case"uint8":return i.getUint8(t);case"int16":return i.getInt16(t,!0);case"uint16":return i.getUint16(t,!0);case"int32":return i.getInt32(t,!0);case"uint32":return i.getUint32(t,!0)}}function ib(i,e){return i.scale===0?e:e===tb[i.type]?NaN:e*i.scale}function Fm(i){return pd.reduce((e,t)=>e+Um[t.type]*(t.count||i),0)}function Om(i){let e=new DataView(i);if(e.getUint8(0)!==1)throw new jo(`the robot shows layout ${e.getUint8(0)}, this page knows ${1}`);let t=e.getUint8(1);if(i.byteLength!==Fm(t))throw new RangeError(`a view frame of ${t} joints has ${Fm(t)} bytes, this one ${i.byteLength}`);let n={},s=0;for(let r of pd){let o=[];for(let a=0;a<(r.count||t);++a)o.push(ib(r,nb(e,r.type,s))),s+=Um[r.type];n[r.name]=o}return n}function Bm(i){let e=new Uint8Array(4);return new DataView(e.buffer).setUint32(0,i.frame[0]??0,!0),e}function Tl(i){let e=i.commander.indexOf(0);return new TextDecoder().decode(Uint8Array.from(e<0?i.commander:i.commander.slice(0,e)))}function zm(i,e){return((i.joint_trouble[e>>3]??0)>>(e&7)&1)===1}var Ss={batches:0,safeTail:1,holds:2,emergencyStop:3},Hm=["not known","stands","walks","plays a motion","falls","lies"],Vm=5,Gm=["plays batches","plays a safe tail","holds, waits for a batch","emergency stop"],El=["joints","pose","message controller","plan","robot's clock"];var gd="nobody commands",Al=class{constructor(e){this.context=e;let{attempt:t,command:n}=e;he(tt("robot-name"),e.description.name),document.title=`${e.description.name} – Gaitway`,this.take.addEventListener("click",()=>void t("Take the command",()=>n.take())),this.give.addEventListener("click",()=>void t("Give the command back",()=>n.giveBack()))}lamp=tt("link");lampText=tt("link-text");activity=tt("activity");commander=tt("commander");old=tt("old");take=tt("take");give=tt("give");canvas=tt("scene");look(e){let{freshness:t}=this.context,n=t.state(e);this.lamp.className=`lamp ${n}`,he(this.lampText,this.linkText(e)),this.old.hidden=n==="live",n!=="live"&&he(this.old,this.oldText(e));let s=n==="lost"?void 0:t.newest;s?this.showFrame(s):this.showNothing(),this.showCommand(s)}linkText(e){let{freshness:t}=this.context,n=Nn(t.pictureAge_ms(e));return t.state(e)==="live"?t.rests?"paused":`live, ${n}`:t.state(e)==="old"?`old, ${n}`:"no connection"}oldText(e){let{freshness:t}=this.context;if(!t.newest)return"Nothing has come from the robot yet.";if(t.state(e)==="lost")return`Connection lost: the picture is ${Nn(t.sinceCame_ms(e))} old. Trying again…`;let n=El.filter((s,r)=>r!==3&&t.age_ms(r,e)>300);return`Old, ${Nn(t.pictureAge_ms(e))}: ${n.join(", ")}.`}showNothing(){he(this.activity,""),this.activity.classList.remove("alarm","caution"),this.canvas.setAttribute("aria-label","The robot, as it was last seen")}showFrame(e){let t=e.mode[0]??NaN,n=Hm[e.activity[0]??0]??"",s=t===Ss.batches?n:`${Gm[t]??"state not known"}, ${n}`;he(this.activity,s),this.activity.classList.toggle("alarm",t===Ss.emergencyStop||(e.activity[0]??0)>=4),this.activity.classList.toggle("caution",t===Ss.safeTail);let r=Math.hypot(e.velocity[0]??0,e.velocity[1]??0);this.canvas.setAttribute("aria-label",`The robot ${s}${r>.03?`, ${r.toFixed(1)} m/s`:""}`)}showCommand(e){let{command:t,robot:n}=this.context,s=e?Tl(e):"",r=!t.mine&&s!=="";he(this.commander,t.mine?"you command":r?`${s} commands`:e?gd:""),this.commander.classList.toggle("mine",t.mine),this.take.hidden=t.mine,this.take.disabled=r||!n.isOpen,this.give.hidden=!t.mine}};var sb=3e3,Rl=class{constructor(e){this.context=e;let{robot:t,attempt:n,command:s}=e;this.button.addEventListener("click",()=>void n("Let the behaviour command",()=>s.during(()=>t.order("/command/let_go")))),t.subscribe("/command/state","gaitway_msgs/msg/CommandState",0,r=>this.command=wl(r)),t.subscribe("/behaviour/state","gaitway_msgs/msg/BehaviourState",0,r=>{this.behaviour=bl(r),this.behaviour_ms=performance.now()})}box=tt("authority");text=tt("authority-text");person=tt("commander");button=tt("let-go");command;behaviour;behaviour_ms=-1/0;look(e){let{robot:t}=this.context,n=t.isOpen?Dm(this.command,e-this.behaviour_ms>sb?void 0:this.behaviour):void 0;this.box.hidden=n===void 0,this.person.hidden=n!==void 0&&this.person.textContent===gd,n&&(he(this.text,n.text),this.text.title=n.why,this.button.hidden=!n.lets_go)}};function Wm(i,e,t){let n=ke("Follow",()=>{e.follows=!e.follows,n.setAttribute("aria-pressed",String(e.follows))},{"aria-pressed":"true",title:"The camera goes with the robot"}),s=["behind","front","side","top"];i.append(n,...s.map(r=>ke(r[0]?.toUpperCase()+r.slice(1),()=>e.lookFrom(r),{title:`Look from ${r}`})),ke("+",()=>e.zoom(.8),{"aria-label":"Nearer"}),ke("−",()=>e.zoom(1.25),{"aria-label":"Farther"}),...t?[t.toggle,t.form]:[])}var $m=[700,700,2500],Xr=class{constructor(e,t){this.url=e;this.user=t}socket;timer;tries=0;ended=!1;start(){this.ended=!1,this.tryOnce()}stop(){this.ended=!0,this.drop("")}restart(e){this.drop(e),this.ended||(this.timer=setTimeout(()=>this.tryOnce(),200))}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(e),!0)}tryOnce(){clearTimeout(this.timer);let e=new WebSocket(this.url);e.binaryType="arraybuffer",this.socket=e,this.timer=setTimeout(()=>this.restart("no answer"),$m[this.tries++%$m.length]),e.onopen=()=>{clearTimeout(this.timer),this.tries=0,this.user.opened(e)},e.onmessage=t=>this.user.received(t.data),e.onclose=t=>this.restart(t.reason)}drop(e){clearTimeout(this.timer);let t=this.socket;this.socket=void 0,t&&(t.onopen=t.onmessage=t.onclose=null,t.close(),this.user.closed(e))}};function yd(i){return`${location.protocol==="https:"?"wss":"ws"}://${location.host}${i}`}var Qs=class extends Error{},Fn=class extends Error{};function Ym(i){return i.includes("late: it may have been sent")}function Zm(i){return i.includes("given before a stop")||i.includes("a stop that this connection called later")}var Xm=3e3,qm=1e3,rb=20,Cl=class{constructor(e,t){this.token=t;this.keeper=new Xr(e,this)}keeper;waiting=new Map;subscriptions=new Map;lastId=0;open=!1;onOpen=()=>{};onClose=()=>{};onStatus=()=>{};start(){this.keeper.start(),setInterval(()=>void this.probe(),qm)}get isOpen(){return this.open}call(e,t={},n=Xm){return new Promise((s,r)=>{let o=`${e}#${++this.lastId}`;if(!this.keeper.send(JSON.stringify({op:"call_service",id:o,service:e,args:t}))){r(new Fn(`${e} was not sent: there is no connection to the robot`));return}let a=setTimeout(()=>{this.waiting.delete(o),r(new Qs(`${e} was sent, but not answered within ${n/1e3} s`))},n);this.waiting.set(o,{service:e,resolve:s,reject:r,timer:a})})}async order(e,t={},n=Xm){let s=await this.call(e,t,n);if(!s.success)throw new Fn(s.message||`${e} was refused`);return s}async stop(e,t={}){let n=this.order(e,t),s=JSON.stringify({op:"call_service",id:`${e}#${this.lastId}`,service:e,args:t}),r=setInterval(()=>this.keeper.send(s),rb);try{return await n}finally{clearInterval(r)}}publish(e,t){return this.keeper.send(JSON.stringify({op:"publish",topic:e,msg:t}))}subscribe(e,t,n,s){let r=this.subscriptions.get(e);r||(r={type:t,throttle_ms:n,takers:new Set},this.subscriptions.set(e,r),this.sendSubscription(e,r));let{takers:o}=r;return o.add(s),()=>{o.delete(s),!(o.size>0||!this.subscriptions.delete(e))&&this.keeper.send(JSON.stringify({op:"unsubscribe",topic:e}))}}opened(){this.open=!0;let e=this.token();e!==void 0&&this.keeper.send(JSON.stringify({op:"auth",token:e}));for(let[t,n]of this.subscriptions)this.sendSubscription(t,n);this.onOpen()}closed(){let e=[...this.waiting.values()];this.waiting.clear();for(let{service:t,reject:n,timer:s}of e)clearTimeout(s),n(new Qs(`${t} was sent, but the connection was lost before its answer`));this.open&&this.onClose(),this.open=!1}received(e){let t=JSON.parse(e);if(t.op==="publish")for(let n of this.subscriptions.get(t.topic)?.takers??[])n(t.msg);else t.op==="service_response"?this.answered(t):t.op==="status"&&this.onStatus(String(t.level),String(t.msg))}answered(e){let t=e.id,n=this.waiting.get(t);n&&(this.waiting.delete(t),clearTimeout(n.timer),e.result===!0?n.resolve(e.values):n.reject(new Fn(String(e.values))))}sendSubscription(e,{type:t,throttle_ms:n}){this.keeper.send(JSON.stringify({op:"subscribe",topic:e,type:t,throttle_rate:n,queue_length:n?1:100}))}async probe(){if(this.open)try{await this.call("/rosapi/get_time",{},qm)}catch(e){e instanceof Qs&&this.open&&this.keeper.restart("no answer")}}};var Pl=class{constructor(e,t){this.robot=e;this.name=t}name;lease;period_ms=0;kept_ms=0;asking;onChange=()=>{};get mine(){return this.lease!==void 0}take(){return this.asking??=this.ask().finally(()=>this.asking=void 0),this.asking}async giveBack(){let e=this.lease;this.lost(),e!==void 0&&await this.robot.order("/command/release",{lease:e})}async during(e){if(this.mine)return e();await this.take();try{return await e()}finally{await this.giveBack()}}lost(){this.lease!==void 0&&(this.lease=void 0,this.onChange())}async keep(e){let t=this.lease;if(!(t===void 0||e-this.kept_ms<this.period_ms)){this.kept_ms=e;try{await this.robot.order("/command/keep_alive",{lease:t})}catch(n){throw this.lease===t&&n instanceof Fn&&this.lost(),n}}}async ask(){let e=await this.robot.order("/command/acquire",{name:this.name});this.lease=String(e.lease),this.period_ms=Number(e.keep_alive_period)*1e3/2,this.kept_ms=performance.now(),this.onChange()}};var Jo=class extends Error{};function Qi(i){return i===void 0?{}:{headers:{Authorization:`Bearer ${i}`}}}async function Km(i){let e=await fetch("robot.json",Qi(i));if(e.status===401)throw new Jo(await e.text());if(!e.ok)throw new Error(await e.text());return await e.json()}var es={forward:0,left:0,turn:0},ob=80,ab=400;function qr(i){return i.forward===0&&i.left===0&&i.turn===0}function jm(i,e){let t=s=>Math.max(-1,Math.min(1,s)),n=t(i.ahead);return{forward:n*(n<0?e.backward:e.forward),left:t(i.left)*e.left,turn:t(i.turn)*e.turn}}var Il=class{current="rests";wanted=es;sent_ms=-1/0;late_ms=-1/0;lateSince_ms=-1/0;get state(){return this.current}hold(e,t){return this.wanted=e,this.current!=="rests"||qr(e)?!1:(this.current=t?"drives":"waits",this.sent_ms=-1/0,!t)}granted(){this.current==="waits"&&(this.current="drives")}letGo(){let e=this.current==="drives";return this.current="rests",this.wanted=es,e?es:void 0}end(){let e=this.current==="drives";return this.current!=="rests"&&(this.current="blocked"),e}late(e,t){return e-this.late_ms>ab&&(this.lateSince_ms=e),this.late_ms=e,e-this.lateSince_ms>=t&&this.end()}due(e){if(!(this.current!=="drives"||e-this.sent_ms<ob))return this.sent_ms=e,this.wanted}};function vd({bounds:i}){return{forward:i.forward,backward:i.forward,left:i.forward,turn:i.turn}}function lb(i,e){let t=n=>{let s=Number(i[n]);return Number.isFinite(s)?Math.min(s,e[n]):e[n]};return{forward:t("forward"),backward:t("backward"),left:t("left"),turn:t("turn")}}async function Jm(i,e){return lb(await i.call("/walk/limits"),vd(e))}var Qm={KeyW:{ahead:1},ArrowUp:{ahead:1},KeyS:{ahead:-1},ArrowDown:{ahead:-1},KeyA:{turn:1},ArrowLeft:{turn:1},KeyD:{turn:-1},ArrowRight:{turn:-1},KeyQ:{left:1},KeyE:{left:-1}},cb=.6,_d=.15,hb=i=>Math.abs(i)<_d?0:(i-Math.sign(i)*_d)/(1-_d),Ll=class{held=new Set;fast=!1;press(e){return this.fast=e.shiftKey,!(e.code in Qm)||e.ctrlKey||e.altKey||e.metaKey||Js(e.target)?!1:(this.held.add(e.code),!0)}release(e){this.fast=e.shiftKey,this.held.delete(e.code)}letGo(){this.held.clear()}get wish(){let e={ahead:0,left:0,turn:0};for(let n of this.held){let s=Qm[n];e.ahead+=s?.ahead??0,e.left+=s?.left??0,e.turn+=s?.turn??0}let t=this.fast?1:cb;return{ahead:Math.sign(e.ahead)*t,left:Math.sign(e.left)*t,turn:Math.sign(e.turn)*t}}},Qo=class{constructor(e,t,n){this.changed=n;this.field=A("div",{class:`stick ${e}`,role:"img","aria-label":t,title:t},this.knob),this.field.addEventListener("pointerdown",s=>this.grasp(s)),this.field.addEventListener("pointermove",s=>this.move(s));for(let s of["pointerup","pointercancel","lostpointercapture"])this.field.addEventListener(s,r=>r.pointerId===this.pointer&&this.letGo())}field;knob=A("div",{class:"knob"});pointer;x=0;y=0;letGo(){this.pointer=void 0,this.place(0,0)}mirror(e,t){this.pointer===void 0&&this.draw(e,t)}grasp(e){e.button!==0||this.pointer!==void 0||(e.preventDefault(),this.pointer=e.pointerId,this.field.setPointerCapture(e.pointerId),this.move(e))}move(e){if(e.pointerId!==this.pointer)return;let t=this.field.getBoundingClientRect(),n=Math.min(t.width,t.height)/2-20,s=(e.clientX-t.left-t.width/2)/(this.field.classList.contains("wide")?t.width/2-24:n),r=this.field.classList.contains("wide")?0:-(e.clientY-t.top-t.height/2)/n,o=Math.hypot(s,r);o>1&&(s/=o,r/=o),this.place(s,r)}place(e,t){this.x=e,this.y=t,this.draw(e,t),this.changed()}draw(e,t){this.knob.style.setProperty("--x",String(e)),this.knob.style.setProperty("--y",String(-t))}},kl=class{stopHeld=!1;onStop=()=>{};get wish(){let e=navigator.getGamepads?.().find(s=>s?.connected);if(!e)return;let t=e.buttons.slice(0,4).some(s=>s.pressed);t&&!this.stopHeld&&this.onStop(),this.stopHeld=t;let n=s=>hb(e.axes[s]??0);return{ahead:-n(1),left:-n(0),turn:-n(2)}}};function eg(i){let e=t=>Math.abs(t.ahead)+Math.abs(t.left)+Math.abs(t.turn);return i.reduce((t,n)=>n&&e(n)>e(t)?n:t,{ahead:0,left:0,turn:0})}var ub=1,xd=i=>Math.round(100*i)/100,Dl=class{began_ms;since_ms=0;now;way={forward:0,left:0,turn:0};last;take(e,t){let{began_ms:n,now:s}=this;if(s){let r=(t-this.since_ms)/1e3;this.way={forward:this.way.forward+r*s.forward,left:this.way.left+r*s.left,turn:this.way.turn+r*s.turn}}this.since_ms=t,this.now=qr(e)?void 0:e,this.now&&n===void 0?(this.began_ms=t,this.way={forward:0,left:0,turn:0}):!this.now&&n!==void 0&&this.end((t-n)/1e3)}get walk(){return this.last}end(e){if(this.began_ms=void 0,e<=0)return;let t={forward:xd(this.way.forward/e),left:xd(this.way.left/e),turn:xd(this.way.turn/e)};qr(t)||(this.last={...t,duration_s:Math.max(Math.round(10*e)/10,ub)})}};var db=20,fb=2e3,pb=700,Nl=class{constructor(e){this.context=e;this.bounds=vd(e.description),document.addEventListener("keydown",t=>{this.keys.press(t)&&t.preventDefault(),this.look()}),document.addEventListener("keyup",t=>{this.keys.release(t),this.look()}),window.addEventListener("blur",()=>this.letGo()),window.addEventListener("pagehide",()=>this.leave()),document.addEventListener("visibilitychange",()=>document.hidden&&this.leave()),setInterval(()=>this.look(),db)}walk=new Qo("round","Walk: up and down ahead and back, sideways turns. Keys W, A, S, D or arrows.",()=>this.look());side=new Qo("wide","Sidestep to the left and right. Keys Q and E.",()=>this.look());pad=new kl;lastWalk=new Dl;keys=new Ll;foreignSince_ms;boundsRead_ms=-1/0;boundsKnown=!1;retired=!1;bounds;sent=es;end(){this.context.drive.end()&&this.publish(es)}lost(){let{drive:e,command:t,news:n}=this.context;t.mine&&n.say("The connection was lost, and with it the command.","bad"),e.end(),t.lost(),this.sent=es,this.lastWalk.take(es,performance.now())}late(e){let{drive:t,news:n,description:s}=this.context;t.late(e,s.bounds.velocity_holds*1e3)&&n.say("The drive has ended: what you ask for comes too late, since the connection, or this computer, is slow. Let go of the stick first.","bad")}retire(){this.leave(),this.retired=!0}letGo(){this.keys.letGo(),this.walk.letGo(),this.side.letGo()}leave(){this.letGo(),this.end(),this.context.command.mine&&this.context.command.giveBack().catch(()=>{})}look(){let e=this.pad.wish;if(this.retired)return;let{drive:t,freshness:n,command:s,news:r}=this.context,o=performance.now(),a={ahead:this.walk.y,turn:-this.walk.x,left:-this.side.x},l=eg([a,this.keys.wish,document.hidden?void 0:e]);this.walk.mirror(-l.turn,l.ahead),this.side.mirror(-l.left,0);let c=this.boundsKnown?jm(l,this.bounds):es;if(qr(c)){let u=t.letGo();u&&this.publish(u)}else t.hold(c,s.mine)&&s.take().then(()=>t.granted(),u=>{t.end(),r.say(`You cannot drive: ${u.message}`,"bad")});t.state==="drives"&&n.state(o)==="lost"&&(this.end(),r.say("Nothing comes from the robot any more: the drive has ended. Let go of the stick first.","bad"));let h=t.due(o);h&&this.publish(h),this.keepCommand(o),this.keepBounds(o)}publish({forward:e,left:t,turn:n}){this.sent={forward:e,left:t,turn:n},this.lastWalk.take(this.sent,performance.now()),this.context.robot.publish("/cmd_vel",{linear:{x:e,y:t},angular:{z:n}})}keepCommand(e){let{command:t,freshness:n,news:s,drive:r}=this.context;if(!t.mine){this.foreignSince_ms=void 0;return}t.keep(e).catch(l=>{l instanceof Fn&&(r.end(),s.say("You do not command any more: the robot has not heard from this page in time (is this computer busy?), or somebody has stopped it.","bad"))});let o=n.newest,a=o!==void 0&&n.state(e)!=="lost"&&Tl(o)!==t.name;this.foreignSince_ms=a?this.foreignSince_ms??e:void 0,!(this.foreignSince_ms===void 0||e-this.foreignSince_ms<pb)&&(r.end(),t.lost(),s.say("You do not command any more: somebody has stopped the robot, or the connection was too slow.","bad"))}keepBounds(e){let{robot:t,description:n}=this.context;!t.isOpen||document.hidden||e-this.boundsRead_ms<fb||(this.boundsRead_ms=e,Jm(t,n).then(s=>{this.bounds=s,this.boundsKnown=!0},()=>{}))}};var bd=i=>i===""?"":i.charAt(0).toUpperCase()+i.slice(1)+(/[.?!]$/.test(i)?"":".");function tg({otherVersion:i,link:e,linkTold_ms:t,certificate:n},s){if(i!==void 0)return{text:i,weight:"bad",action:"reload"};if(e&&e.state!=="up"){let o=`For ${Nn(e.seconds*1e3+s-t)}.`;return{text:`${bd(`the robot is not there: ${e.text}`)} ${bd(n)}`.trim(),age:o,weight:"bad",action:void 0}}let r=[e?.text??"",n].map(bd).join(" ").trim();return r===""?void 0:{text:r,weight:"caution",action:"hide"}}var Fl=class{constructor(e){this.robot=e;e.subscribe("/link_state","gaitway_msgs/msg/LinkState",0,t=>{this.known.link=t,this.known.linkTold_ms=performance.now()}),e.subscribe("/certificate_state","std_msgs/msg/String",0,t=>this.known.certificate=String(t.data)),this.button.addEventListener("click",()=>{this.known.otherVersion!==void 0?location.reload():this.hidden=this.text.textContent??""})}box=tt("trouble");text=tt("trouble-text");age=tt("trouble-age");button=tt("trouble-button");known={linkTold_ms:0,certificate:""};rests=!1;hidden="";otherVersion(e){this.known.otherVersion=e}look(e){this.robot.isOpen||delete this.known.link;let{link:t,...n}=this.known,s=tg(t&&!this.rests?this.known:n,e);this.box.hidden=!s||s.action==="hide"&&s.text===this.hidden,s&&(this.box.className=`trouble ${s.weight}`,he(this.text,s.text),he(this.age,s.age??""),this.button.hidden=s.action===void 0,he(this.button,s.action==="reload"?"Load again":"Hide"))}};var mb={good:4e3,plain:6e3,bad:12e3},gb=4,Ul=class{constructor(e){this.list=e}say(e,t="plain",n=e){for(let r of[...this.list.children])r instanceof HTMLElement&&r.dataset.about===n&&r.remove();let s=A("p",{class:t,"data-about":n},e);for(this.list.append(s);this.list.childElementCount>gb;)this.list.firstElementChild?.remove();setTimeout(()=>s.remove(),mb[t])}};var Ol=class{tools=[];before;add(...e){this.tools.push(...e)}choose(e){let t=this.tools.find(n=>n!==e&&n.on);t?.setOn(!1),this.before=t}done(e){if(!e.on)return;let{before:t}=this;e.setOn(!1),t?.setOn(!0)}};function er([i,e,t,n]){return Math.atan2(2*(i*e+n*t),1-2*(e*e+t*t))}function yb(i,{least:e,most:t}){return Math.min(Math.max(i,e),t)}function ng(i,e,t,n,s){let r=Math.hypot(i,e),o=r<=6,a=yb(o?n:r*1,s),[l,c]=o?[0,1]:[i/r,e/r];return[a*(c*t[0]+l*t[1]),a*(c*t[1]-l*t[0])]}function wd([i,e],t){let[n,s]=[Math.cos(t),Math.sin(t)];return[n*i+s*e,n*e-s*i]}function Md([i,e]){return Math.hypot(i,e)}function ig(i,[e,t]){return{link:i,force:{x:e,y:t,z:0},duration:.1,frame:"heading"}}var _b=900,xb=[{text:"↑",name:"ahead",force:[1,0]},{text:"↓",name:"back",force:[-1,0]},{text:"←",name:"to its left",force:[0,1]},{text:"→",name:"to its right",force:[0,-1]}],Bl=class{constructor(e,t,n,s,r){this.context=e;this.scene=t;this.canvas=n;this.bounds=s;this.tools=r;let{links:o}=e.description;this.link=A("select",{"aria-label":"Link that is pushed"},...o.map(({name:l})=>A("option",{},l))),this.newtons=A("input",{type:"number","aria-label":"Force of a push in newtons",min:Math.ceil(s.least),max:s.most,step:1,value:s.usual}),this.toggle=ke("Push",()=>this.on?this.tools.done(this):this.setOn(!0),{"aria-pressed":"false",id:"push",title:"Push the robot: click or drag on a part of it"}),this.form=A("div",{class:"push-form",role:"group","aria-label":"Push the robot",hidden:!0},this.link,this.newtons,"N",...xb.map(({text:l,name:c,force:h})=>ke(l,()=>this.pushBy(h),{"aria-label":`Push ${c}`,title:`Push ${c}`}))),n.after(this.label);let a=(l,c)=>n.addEventListener(l,c,{capture:!0});a("pointerdown",l=>this.begin(l)),a("pointermove",l=>this.move(l)),a("pointerup",l=>this.end(l)),a("pointercancel",()=>this.cancel()),n.addEventListener("pointerleave",()=>this.label.hidden=!this.drag),window.addEventListener("keydown",l=>l.key==="Escape"&&this.cancel(),{capture:!0})}toggle;form;link;newtons;label=A("p",{class:"push-label",role:"status",hidden:!0});drag;shown=0;get on(){return this.toggle.getAttribute("aria-pressed")==="true"}setOn(e){e!==this.on&&(e&&this.tools.choose(this),this.toggle.setAttribute("aria-pressed",String(e)),this.form.hidden=!e,this.canvas.classList.toggle("pushes",e),!e&&(this.cancel(),this.label.hidden=!0))}begin(e){if(this.drag){this.cancel();return}let t=this.on&&e.button===0?this.scene.gripAt(e.clientX,e.clientY):void 0;t&&(e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId),this.link.selectedIndex=t.link,this.drag={pointer:e.pointerId,x:e.clientX,y:e.clientY,grip:t,force:[0,0]},this.move(e))}move(e){if(this.drag||this.tellLink(e),e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{x:t,y:n,grip:s}=this.drag;this.drag.force=ng(e.clientX-t,n-e.clientY,this.scene.away(),this.chosen_N,this.bounds),this.showArrow(s,this.drag.force),this.tell(e,`${this.linkName(s.link)}: ${Md(this.drag.force).toFixed(0)} N`)}tellLink(e){let t=this.on&&e.buttons===0?this.scene.gripAt(e.clientX,e.clientY):void 0;this.label.hidden=!t,t&&this.tell(e,this.linkName(t.link))}tell(e,t){he(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}end(e){if(e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{grip:t,force:n}=this.drag;this.drag=void 0,this.label.hidden=!0,this.push(t,wd(n,this.heading()))}cancel(){this.drag&&(this.drag=void 0,this.label.hidden=!0,this.scene.hidePush())}pushBy([e,t]){let n=this.chosen_N;this.push(this.scene.gripOn(this.link.selectedIndex),[e*n,t*n])}push(e,t){if(!e)return;this.showArrow(e,wd(t,-this.heading()));let n=this.shown;setTimeout(()=>n===this.shown&&this.scene.hidePush(),_b);let s=this.linkName(e.link);this.context.attempt(`Push of ${s}, ${Md(t).toFixed(0)} N for ${.1} s`,()=>this.context.robot.order("/simulation/push",ig(s,t)))}showArrow(e,t){this.shown+=1,this.scene.showPush(e,t)}get chosen_N(){let{least:e,most:t,usual:n}=this.bounds;return Math.min(Math.max(Number(this.newtons.value)||n,e),t)}heading(){let{x:e,y:t,z:n,w:s}=this.scene.body.base.quaternion;return er([e,t,n,s])}linkName(e){return this.context.description.links[e]?.name??""}};/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Ei={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ai={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ng=0,uf=1,Fg=2;var df=1,Ug=2,$i=3,ls=0,On=1,hi=2,ds=0,or=1,ff=2,pf=3,mf=4,Uc=5,ks=100,Og=101,Bg=102,zg=103,Hg=104,Vg=200,Gg=201,Wg=202,$g=203,co=204,ho=205,Xg=206,qg=207,Yg=208,Zg=209,Kg=210,jg=211,Jg=212,Qg=213,e0=214,Oc=0,Bc=1,zc=2,ar=3,Hc=4,Vc=5,Gc=6,Wc=7,$c=0,t0=1,n0=2,fs=0,i0=1,s0=2,r0=3,o0=4,a0=5,l0=6,c0=7;var gf=300,_r=301,xr=302,Xc=303,qc=304,za=306,hc=1e3,Ls=1001,uc=1002,ci=1003,h0=1004;var Ha=1005;var Si=1006,Yc=1007;var Bs=1008;var Ri=1009,yf=1010,vf=1011,Mo=1012,Zc=1013,zs=1014,Xi=1015,So=1016,Kc=1017,jc=1018,To=1020,_f=35902,xf=35899,bf=1021,wf=1022,ui=1023,uo=1026,Eo=1027,Mf=1028,Jc=1029,Sf=1030,Qc=1031;var eh=1033,Va=33776,Ga=33777,Wa=33778,$a=33779,th=35840,nh=35841,ih=35842,sh=35843,rh=36196,oh=37492,ah=37496,lh=37808,ch=37809,hh=37810,uh=37811,dh=37812,fh=37813,ph=37814,mh=37815,gh=37816,yh=37817,vh=37818,_h=37819,xh=37820,bh=37821,wh=36492,Mh=36494,Sh=36495,Th=36283,Eh=36284,Ah=36285,Rh=36286;var ha=2300,dc=2301,cc=2302,Kd=2400,jd=2401,Jd=2402;var u0=3200,d0=3201;var Tf=0,f0=1,ps="",Ht="srgb",lr="srgb-linear",ua="linear",Pt="srgb";var rr=7680;var Qd=519,p0=512,m0=513,g0=514,Ef=515,y0=516,v0=517,_0=518,x0=519,ef=35044;var Af="300 es",Mi=2e3,da=2001;var Bi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Tn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],sg=1234567,oa=Math.PI/180,fo=180/Math.PI;function br(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Tn[i&255]+Tn[i>>8&255]+Tn[i>>16&255]+Tn[i>>24&255]+"-"+Tn[e&255]+Tn[e>>8&255]+"-"+Tn[e>>16&15|64]+Tn[e>>24&255]+"-"+Tn[t&63|128]+Tn[t>>8&255]+"-"+Tn[t>>16&255]+Tn[t>>24&255]+Tn[n&255]+Tn[n>>8&255]+Tn[n>>16&255]+Tn[n>>24&255]).toLowerCase()}function ct(i,e,t){return Math.max(e,Math.min(t,i))}function Rf(i,e){return(i%e+e)%e}function bb(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function wb(i,e,t){return i!==e?(t-i)/(e-i):0}function aa(i,e,t){return(1-t)*i+t*e}function Mb(i,e,t,n){return aa(i,e,1-Math.exp(-t*n))}function Sb(i,e=1){return e-Math.abs(Rf(i,e*2)-e)}function Tb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Eb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Ab(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Rb(i,e){return i+Math.random()*(e-i)}function Cb(i){return i*(.5-Math.random())}function Pb(i){i!==void 0&&(sg=i);let e=sg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Ib(i){return i*oa}function Lb(i){return i*fo}function kb(i){return(i&i-1)===0&&i!==0}function Db(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Nb(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Fb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function oo(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Un(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var Xa={DEG2RAD:oa,RAD2DEG:fo,generateUUID:br,clamp:ct,euclideanModulo:Rf,mapLinear:bb,inverseLerp:wb,lerp:aa,damp:Mb,pingpong:Sb,smoothstep:Tb,smootherstep:Eb,randInt:Ab,randFloat:Rb,randFloatSpread:Cb,seededRandom:Pb,degToRad:Ib,radToDeg:Lb,isPowerOfTwo:kb,ceilPowerOfTwo:Db,floorPowerOfTwo:Nb,setQuaternionFromProperEuler:Fb,normalize:Un,denormalize:oo},we=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},en=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(a===1){e[t+0]=d,e[t+1]=f,e[t+2]=g,e[t+3]=v;return}if(u!==v||l!==d||c!==f||h!==g){let m=1-a,p=l*d+c*f+h*g+u*v,M=p>=0?1:-1,b=1-p*p;if(b>Number.EPSILON){let I=Math.sqrt(b),R=Math.atan2(I,p*M);m=Math.sin(m*R)/I,a=Math.sin(a*R)/I}let _=a*M;if(l=l*m+d*_,c=c*m+f*_,h=h*m+g*_,u=u*m+v*_,m===1-a){let I=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=I,c*=I,h*=I,u*=I}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let f=1-t;return this._w=f*o+t*this._w,this._x=f*n+t*this._x,this._y=f*s+t*this._y,this._z=f*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-t)*h)/c,d=Math.sin(t*h)/c;return this._w=o*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=r*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},O=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(rg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(rg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Sd.copy(this).projectOnVector(e),this.sub(Sd)}reflect(e){return this.sub(Sd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Sd=new O,rg=new en,at=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],v=s[0],m=s[3],p=s[6],M=s[1],b=s[4],_=s[7],I=s[2],R=s[5],D=s[8];return r[0]=o*v+a*M+l*I,r[3]=o*m+a*b+l*R,r[6]=o*p+a*_+l*D,r[1]=c*v+h*M+u*I,r[4]=c*m+h*b+u*R,r[7]=c*p+h*_+u*D,r[2]=d*v+f*M+g*I,r[5]=d*m+f*b+g*R,r[8]=d*p+f*_+g*D,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/g;return e[0]=u*v,e[1]=(s*c-h*n)*v,e[2]=(a*n-s*o)*v,e[3]=d*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Td.makeScale(e,t)),this}rotate(e){return this.premultiply(Td.makeRotation(-e)),this}translate(e,t){return this.premultiply(Td.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Td=new at;function Cf(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function fa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function b0(){let i=fa("canvas");return i.style.display="block",i}var og={};function po(i){i in og||(og[i]=!0,console.warn(i))}function w0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var ag=new at().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),lg=new at().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ub(){let i={enabled:!0,workingColorSpace:lr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=as(s.r),s.g=as(s.g),s.b=as(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=ao(s.r),s.g=ao(s.g),s.b=ao(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ps?ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return po("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return po("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[lr]:{primaries:e,whitePoint:n,transfer:ua,toXYZ:ag,fromXYZ:lg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ht},outputColorSpaceConfig:{drawingBufferColorSpace:Ht}},[Ht]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:ag,fromXYZ:lg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ht}}}),i}var yt=Ub();function as(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ao(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Yr,fc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Yr===void 0&&(Yr=fa("canvas")),Yr.width=e.width,Yr.height=e.height;let s=Yr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Yr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=fa("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=as(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(as(t[n]/255)*255):t[n]=as(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Ob=0,mo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Ob++}),this.uuid=br(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ed(s[o].image)):r.push(Ed(s[o]))}else r=Ed(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ed(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?fc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Bb=0,Ad=new O,Zn=class i extends Bi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Ls,s=Ls,r=Si,o=Bs,a=ui,l=Ri,c=i.DEFAULT_ANISOTROPY,h=ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Bb++}),this.uuid=br(),this.name="",this.source=new mo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new we(0,0),this.repeat=new we(1,1),this.center=new we(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new at,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Ad).x}get height(){return this.source.getSize(Ad).y}get depth(){return this.source.getSize(Ad).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==gf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case hc:e.x=e.x-Math.floor(e.x);break;case Ls:e.x=e.x<0?0:1;break;case uc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case hc:e.y=e.y-Math.floor(e.y);break;case Ls:e.y=e.y<0?0:1;break;case uc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=gf;Zn.DEFAULT_ANISOTROPY=1;var jt=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let b=(c+1)/2,_=(f+1)/2,I=(p+1)/2,R=(h+d)/4,D=(u+v)/4,N=(g+m)/4;return b>_&&b>I?b<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(b),s=R/n,r=D/n):_>I?_<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(_),n=R/s,r=N/s):I<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),n=D/r,s=N/r),this.set(n,s,r,t),this}let M=Math.sqrt((m-g)*(m-g)+(u-v)*(u-v)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(u-v)/M,this.z=(d-h)/M,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},pc=class extends Bi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Si,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new jt(0,0,e,t),this.scissorTest=!1,this.viewport=new jt(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Zn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:Si,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new mo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},zi=class extends pc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},pa=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var mc=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Hi=class{constructor(e=new O(1/0,1/0,1/0),t=new O(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(xi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(xi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=xi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,xi):xi.fromBufferAttribute(r,o),xi.applyMatrix4(e.matrixWorld),this.expandByPoint(xi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),zl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),zl.copy(n.boundingBox)),zl.applyMatrix4(e.matrixWorld),this.union(zl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,xi),xi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ea),Hl.subVectors(this.max,ea),Zr.subVectors(e.a,ea),Kr.subVectors(e.b,ea),jr.subVectors(e.c,ea),Ts.subVectors(Kr,Zr),Es.subVectors(jr,Kr),tr.subVectors(Zr,jr);let t=[0,-Ts.z,Ts.y,0,-Es.z,Es.y,0,-tr.z,tr.y,Ts.z,0,-Ts.x,Es.z,0,-Es.x,tr.z,0,-tr.x,-Ts.y,Ts.x,0,-Es.y,Es.x,0,-tr.y,tr.x,0];return!Rd(t,Zr,Kr,jr,Hl)||(t=[1,0,0,0,1,0,0,0,1],!Rd(t,Zr,Kr,jr,Hl))?!1:(Vl.crossVectors(Ts,Es),t=[Vl.x,Vl.y,Vl.z],Rd(t,Zr,Kr,jr,Hl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,xi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(xi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ts[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ts[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ts),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ts=[new O,new O,new O,new O,new O,new O,new O,new O],xi=new O,zl=new Hi,Zr=new O,Kr=new O,jr=new O,Ts=new O,Es=new O,tr=new O,ea=new O,Hl=new O,Vl=new O,nr=new O;function Rd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){nr.fromArray(i,r);let a=s.x*Math.abs(nr.x)+s.y*Math.abs(nr.y)+s.z*Math.abs(nr.z),l=e.dot(nr),c=t.dot(nr),h=n.dot(nr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var zb=new Hi,ta=new O,Cd=new O,cr=class{constructor(e=new O,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):zb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ta.subVectors(e,this.center);let t=ta.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ta,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Cd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ta.copy(e.center).add(Cd)),this.expandByPoint(ta.copy(e.center).sub(Cd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ns=new O,Pd=new O,Gl=new O,As=new O,Id=new O,Wl=new O,Ld=new O,Ds=class{constructor(e=new O,t=new O(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ns)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ns.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ns.copy(this.origin).addScaledVector(this.direction,t),ns.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Pd.copy(e).add(t).multiplyScalar(.5),Gl.copy(t).sub(e).normalize(),As.copy(this.origin).sub(Pd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Gl),a=As.dot(this.direction),l=-As.dot(Gl),c=As.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let v=1/h;u*=v,d*=v,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Pd).addScaledVector(Gl,d),f}intersectSphere(e,t){ns.subVectors(e.center,this.origin);let n=ns.dot(this.direction),s=ns.dot(ns)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ns)!==null}intersectTriangle(e,t,n,s,r){Id.subVectors(t,e),Wl.subVectors(n,e),Ld.crossVectors(Id,Wl);let o=this.direction.dot(Ld),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;As.subVectors(this.origin,e);let l=a*this.direction.dot(Wl.crossVectors(As,Wl));if(l<0)return null;let c=a*this.direction.dot(Id.cross(As));if(c<0||l+c>o)return null;let h=-a*As.dot(Ld);return h<0?null:this.at(h/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Tt=class i{constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,v,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Jr.setFromMatrixColumn(e,0).length(),r=1/Jr.setFromMatrixColumn(e,1).length(),o=1/Jr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,v=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-v*c,t[9]=-a*l,t[2]=v-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,v=c*u;t[0]=d+v*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=v+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,v=c*u;t[0]=d-v*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=v-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,v=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+v,t[1]=l*u,t[5]=v*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=v-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-v*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,v=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+v,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=v*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Hb,e,Vb)}lookAt(e,t,n){let s=this.elements;return qn.subVectors(e,t),qn.lengthSq()===0&&(qn.z=1),qn.normalize(),Rs.crossVectors(n,qn),Rs.lengthSq()===0&&(Math.abs(n.z)===1?qn.x+=1e-4:qn.z+=1e-4,qn.normalize(),Rs.crossVectors(n,qn)),Rs.normalize(),$l.crossVectors(qn,Rs),s[0]=Rs.x,s[4]=$l.x,s[8]=qn.x,s[1]=Rs.y,s[5]=$l.y,s[9]=qn.y,s[2]=Rs.z,s[6]=$l.z,s[10]=qn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],v=n[6],m=n[10],p=n[14],M=n[3],b=n[7],_=n[11],I=n[15],R=s[0],D=s[4],N=s[8],T=s[12],S=s[1],C=s[5],B=s[9],V=s[13],$=s[2],X=s[6],q=s[10],Q=s[14],Z=s[3],ae=s[7],le=s[11],_e=s[15];return r[0]=o*R+a*S+l*$+c*Z,r[4]=o*D+a*C+l*X+c*ae,r[8]=o*N+a*B+l*q+c*le,r[12]=o*T+a*V+l*Q+c*_e,r[1]=h*R+u*S+d*$+f*Z,r[5]=h*D+u*C+d*X+f*ae,r[9]=h*N+u*B+d*q+f*le,r[13]=h*T+u*V+d*Q+f*_e,r[2]=g*R+v*S+m*$+p*Z,r[6]=g*D+v*C+m*X+p*ae,r[10]=g*N+v*B+m*q+p*le,r[14]=g*T+v*V+m*Q+p*_e,r[3]=M*R+b*S+_*$+I*Z,r[7]=M*D+b*C+_*X+I*ae,r[11]=M*N+b*B+_*q+I*le,r[15]=M*T+b*V+_*Q+I*_e,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],v=e[7],m=e[11],p=e[15];return g*(+r*l*u-s*c*u-r*a*d+n*c*d+s*a*f-n*l*f)+v*(+t*l*f-t*c*d+r*o*d-s*o*f+s*c*h-r*l*h)+m*(+t*c*u-t*a*f-r*o*u+n*o*f+r*a*h-n*c*h)+p*(-s*a*h-t*l*u+t*a*d+s*o*u-n*o*d+n*l*h)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],v=e[13],m=e[14],p=e[15],M=u*m*c-v*d*c+v*l*f-a*m*f-u*l*p+a*d*p,b=g*d*c-h*m*c-g*l*f+o*m*f+h*l*p-o*d*p,_=h*v*c-g*u*c+g*a*f-o*v*f-h*a*p+o*u*p,I=g*u*l-h*v*l-g*a*d+o*v*d+h*a*m-o*u*m,R=t*M+n*b+s*_+r*I;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/R;return e[0]=M*D,e[1]=(v*d*r-u*m*r-v*s*f+n*m*f+u*s*p-n*d*p)*D,e[2]=(a*m*r-v*l*r+v*s*c-n*m*c-a*s*p+n*l*p)*D,e[3]=(u*l*r-a*d*r-u*s*c+n*d*c+a*s*f-n*l*f)*D,e[4]=b*D,e[5]=(h*m*r-g*d*r+g*s*f-t*m*f-h*s*p+t*d*p)*D,e[6]=(g*l*r-o*m*r-g*s*c+t*m*c+o*s*p-t*l*p)*D,e[7]=(o*d*r-h*l*r+h*s*c-t*d*c-o*s*f+t*l*f)*D,e[8]=_*D,e[9]=(g*u*r-h*v*r-g*n*f+t*v*f+h*n*p-t*u*p)*D,e[10]=(o*v*r-g*a*r+g*n*c-t*v*c-o*n*p+t*a*p)*D,e[11]=(h*a*r-o*u*r-h*n*c+t*u*c+o*n*f-t*a*f)*D,e[12]=I*D,e[13]=(h*v*s-g*u*s+g*n*d-t*v*d-h*n*m+t*u*m)*D,e[14]=(g*a*s-o*v*s-g*n*l+t*v*l+o*n*m-t*a*m)*D,e[15]=(o*u*s-h*a*s+h*n*l-t*u*l-o*n*d+t*a*d)*D,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,v=o*h,m=o*u,p=a*u,M=l*c,b=l*h,_=l*u,I=n.x,R=n.y,D=n.z;return s[0]=(1-(v+p))*I,s[1]=(f+_)*I,s[2]=(g-b)*I,s[3]=0,s[4]=(f-_)*R,s[5]=(1-(d+p))*R,s[6]=(m+M)*R,s[7]=0,s[8]=(g+b)*D,s[9]=(m-M)*D,s[10]=(1-(d+v))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Jr.set(s[0],s[1],s[2]).length(),o=Jr.set(s[4],s[5],s[6]).length(),a=Jr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],bi.copy(this);let c=1/r,h=1/o,u=1/a;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=h,bi.elements[5]*=h,bi.elements[6]*=h,bi.elements[8]*=u,bi.elements[9]*=u,bi.elements[10]*=u,t.setFromRotationMatrix(bi),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Mi)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===da)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Mi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Mi)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===da)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Jr=new O,bi=new Tt,Hb=new O(0,0,0),Vb=new O(1,1,1),Rs=new O,$l=new O,qn=new O,cg=new Tt,hg=new en,Kn=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return cg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(cg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return hg.setFromEuler(this),this.setFromQuaternion(hg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Kn.DEFAULT_ORDER="XYZ";var go=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Gb=0,ug=new O,Qr=new en,is=new Tt,Xl=new O,na=new O,Wb=new O,$b=new en,dg=new O(1,0,0),fg=new O(0,1,0),pg=new O(0,0,1),mg={type:"added"},Xb={type:"removed"},eo={type:"childadded",child:null},kd={type:"childremoved",child:null},Mn=class i extends Bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Gb++}),this.uuid=br(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new O,t=new Kn,n=new en,s=new O(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Tt},normalMatrix:{value:new at}}),this.matrix=new Tt,this.matrixWorld=new Tt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new go,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.multiply(Qr),this}rotateOnWorldAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.premultiply(Qr),this}rotateX(e){return this.rotateOnAxis(dg,e)}rotateY(e){return this.rotateOnAxis(fg,e)}rotateZ(e){return this.rotateOnAxis(pg,e)}translateOnAxis(e,t){return ug.copy(e).applyQuaternion(this.quaternion),this.position.add(ug.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(dg,e)}translateY(e){return this.translateOnAxis(fg,e)}translateZ(e){return this.translateOnAxis(pg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(is.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Xl.copy(e):Xl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),na.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?is.lookAt(na,Xl,this.up):is.lookAt(Xl,na,this.up),this.quaternion.setFromRotationMatrix(is),s&&(is.extractRotation(s.matrixWorld),Qr.setFromRotationMatrix(is),this.quaternion.premultiply(Qr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(mg),eo.child=e,this.dispatchEvent(eo),eo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Xb),kd.child=e,this.dispatchEvent(kd),kd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),is.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),is.multiply(e.parent.matrixWorld)),e.applyMatrix4(is),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(mg),eo.child=e,this.dispatchEvent(eo),eo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,e,Wb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(na,$b,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};Mn.DEFAULT_UP=new O(0,1,0);Mn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Mn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wi=new O,ss=new O,Dd=new O,rs=new O,to=new O,no=new O,gg=new O,Nd=new O,Fd=new O,Ud=new O,Od=new jt,Bd=new jt,zd=new jt,Is=class i{constructor(e=new O,t=new O,n=new O){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),wi.subVectors(e,t),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){wi.subVectors(s,t),ss.subVectors(n,t),Dd.subVectors(e,t);let o=wi.dot(wi),a=wi.dot(ss),l=wi.dot(Dd),c=ss.dot(ss),h=ss.dot(Dd),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,rs)===null?!1:rs.x>=0&&rs.y>=0&&rs.x+rs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,rs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,rs.x),l.addScaledVector(o,rs.y),l.addScaledVector(a,rs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Od.setScalar(0),Bd.setScalar(0),zd.setScalar(0),Od.fromBufferAttribute(e,t),Bd.fromBufferAttribute(e,n),zd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Od,r.x),o.addScaledVector(Bd,r.y),o.addScaledVector(zd,r.z),o}static isFrontFacing(e,t,n,s){return wi.subVectors(n,t),ss.subVectors(e,t),wi.cross(ss).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return wi.subVectors(this.c,this.b),ss.subVectors(this.a,this.b),wi.cross(ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;to.subVectors(s,n),no.subVectors(r,n),Nd.subVectors(e,n);let l=to.dot(Nd),c=no.dot(Nd);if(l<=0&&c<=0)return t.copy(n);Fd.subVectors(e,s);let h=to.dot(Fd),u=no.dot(Fd);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return o=l/(l-h),t.copy(n).addScaledVector(to,o);Ud.subVectors(e,r);let f=to.dot(Ud),g=no.dot(Ud);if(g>=0&&f<=g)return t.copy(r);let v=f*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(no,a);let m=h*g-f*u;if(m<=0&&u-h>=0&&f-g>=0)return gg.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(gg,a);let p=1/(m+v+d);return o=v*p,a=d*p,t.copy(n).addScaledVector(to,o).addScaledVector(no,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},M0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Cs={h:0,s:0,l:0},ql={h:0,s:0,l:0};function Hd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ke=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ht){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=n,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=yt.workingColorSpace){if(e=Rf(e,1),t=ct(t,0,1),n=ct(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Hd(o,r,e+1/3),this.g=Hd(o,r,e),this.b=Hd(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=Ht){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ht){let n=M0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=as(e.r),this.g=as(e.g),this.b=as(e.b),this}copyLinearToSRGB(e){return this.r=ao(e.r),this.g=ao(e.g),this.b=ao(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ht){return yt.workingToColorSpace(En.copy(this),e),Math.round(ct(En.r*255,0,255))*65536+Math.round(ct(En.g*255,0,255))*256+Math.round(ct(En.b*255,0,255))}getHexString(e=Ht){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(En.copy(this),t);let n=En.r,s=En.g,r=En.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(En.copy(this),t),e.r=En.r,e.g=En.g,e.b=En.b,e}getStyle(e=Ht){yt.workingToColorSpace(En.copy(this),e);let t=En.r,n=En.g,s=En.b;return e!==Ht?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Cs),this.setHSL(Cs.h+e,Cs.s+t,Cs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Cs),e.getHSL(ql);let n=aa(Cs.h,ql.h,t),s=aa(Cs.s,ql.s,t),r=aa(Cs.l,ql.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},En=new Ke;Ke.NAMES=M0;var qb=0,cs=class extends Bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:qb++}),this.uuid=br(),this.name="",this.type="Material",this.blending=or,this.side=ls,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=co,this.blendDst=ho,this.blendEquation=ks,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ke(0,0,0),this.blendAlpha=0,this.depthFunc=ar,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Qd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=rr,this.stencilZFail=rr,this.stencilZPass=rr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==or&&(n.blending=this.blending),this.side!==ls&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==co&&(n.blendSrc=this.blendSrc),this.blendDst!==ho&&(n.blendDst=this.blendDst),this.blendEquation!==ks&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==ar&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Qd&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==rr&&(n.stencilFail=this.stencilFail),this.stencilZFail!==rr&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==rr&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},An=class extends cs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Kn,this.combine=$c,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new O,Yl=new we,Yb=0,on=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Yb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=ef,this.updateRanges=[],this.gpuType=Xi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Yl.fromBufferAttribute(this,t),Yl.applyMatrix3(e),this.setXY(t,Yl.x,Yl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=oo(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Un(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=oo(t,this.array)),t}setX(e,t){return this.normalized&&(t=Un(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=oo(t,this.array)),t}setY(e,t){return this.normalized&&(t=Un(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=oo(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Un(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=oo(t,this.array)),t}setW(e,t){return this.normalized&&(t=Un(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Un(t,this.array),n=Un(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Un(t,this.array),n=Un(n,this.array),s=Un(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=Un(t,this.array),n=Un(n,this.array),s=Un(s,this.array),r=Un(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==ef&&(e.usage=this.usage),e}};var ma=class extends on{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ga=class extends on{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var dt=class extends on{constructor(e,t,n){super(new Float32Array(e),t,n)}},Zb=0,ai=new Tt,Vd=new Mn,io=new O,Yn=new Hi,ia=new Hi,_n=new O,Vt=class i extends Bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Zb++}),this.uuid=br(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Cf(e)?ga:ma)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new at().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return ai.makeRotationFromQuaternion(e),this.applyMatrix4(ai),this}rotateX(e){return ai.makeRotationX(e),this.applyMatrix4(ai),this}rotateY(e){return ai.makeRotationY(e),this.applyMatrix4(ai),this}rotateZ(e){return ai.makeRotationZ(e),this.applyMatrix4(ai),this}translate(e,t,n){return ai.makeTranslation(e,t,n),this.applyMatrix4(ai),this}scale(e,t,n){return ai.makeScale(e,t,n),this.applyMatrix4(ai),this}lookAt(e){return Vd.lookAt(e),Vd.updateMatrix(),this.applyMatrix4(Vd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(io).negate(),this.translate(io.x,io.y,io.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new dt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Hi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new O(-1/0,-1/0,-1/0),new O(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Yn.setFromBufferAttribute(r),this.morphTargetsRelative?(_n.addVectors(this.boundingBox.min,Yn.min),this.boundingBox.expandByPoint(_n),_n.addVectors(this.boundingBox.max,Yn.max),this.boundingBox.expandByPoint(_n)):(this.boundingBox.expandByPoint(Yn.min),this.boundingBox.expandByPoint(Yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new cr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new O,1/0);return}if(e){let n=this.boundingSphere.center;if(Yn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(_n.addVectors(Yn.min,ia.min),Yn.expandByPoint(_n),_n.addVectors(Yn.max,ia.max),Yn.expandByPoint(_n)):(Yn.expandByPoint(ia.min),Yn.expandByPoint(ia.max))}Yn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)_n.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(_n));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)_n.fromBufferAttribute(a,c),l&&(io.fromBufferAttribute(e,c),_n.add(io)),s=Math.max(s,n.distanceToSquared(_n))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new on(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let N=0;N<n.count;N++)a[N]=new O,l[N]=new O;let c=new O,h=new O,u=new O,d=new we,f=new we,g=new we,v=new O,m=new O;function p(N,T,S){c.fromBufferAttribute(n,N),h.fromBufferAttribute(n,T),u.fromBufferAttribute(n,S),d.fromBufferAttribute(r,N),f.fromBufferAttribute(r,T),g.fromBufferAttribute(r,S),h.sub(c),u.sub(c),f.sub(d),g.sub(d);let C=1/(f.x*g.y-g.x*f.y);isFinite(C)&&(v.copy(h).multiplyScalar(g.y).addScaledVector(u,-f.y).multiplyScalar(C),m.copy(u).multiplyScalar(f.x).addScaledVector(h,-g.x).multiplyScalar(C),a[N].add(v),a[T].add(v),a[S].add(v),l[N].add(m),l[T].add(m),l[S].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let N=0,T=M.length;N<T;++N){let S=M[N],C=S.start,B=S.count;for(let V=C,$=C+B;V<$;V+=3)p(e.getX(V+0),e.getX(V+1),e.getX(V+2))}let b=new O,_=new O,I=new O,R=new O;function D(N){I.fromBufferAttribute(s,N),R.copy(I);let T=a[N];b.copy(T),b.sub(I.multiplyScalar(I.dot(T))).normalize(),_.crossVectors(R,T);let C=_.dot(l[N])<0?-1:1;o.setXYZW(N,b.x,b.y,b.z,C)}for(let N=0,T=M.length;N<T;++N){let S=M[N],C=S.start,B=S.count;for(let V=C,$=C+B;V<$;V+=3)D(e.getX(V+0)),D(e.getX(V+1)),D(e.getX(V+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new on(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new O,r=new O,o=new O,a=new O,l=new O,c=new O,h=new O,u=new O;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),v=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)_n.fromBufferAttribute(e,t),_n.normalize(),e.setXYZ(t,_n.x,_n.y,_n.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let p=0;p<h;p++)d[g++]=c[f++]}return new on(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},yg=new Tt,ir=new Ds,Zl=new cr,vg=new O,Kl=new O,jl=new O,Jl=new O,Gd=new O,Ql=new O,_g=new O,ec=new O,ft=class extends Mn{constructor(e=new Vt,t=new An){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Ql.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Gd.fromBufferAttribute(u,e),o?Ql.addScaledVector(Gd,h):Ql.addScaledVector(Gd.sub(t),h))}t.add(Ql)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Zl.copy(n.boundingSphere),Zl.applyMatrix4(r),ir.copy(e.ray).recast(e.near),!(Zl.containsPoint(ir.origin)===!1&&(ir.intersectSphere(Zl,vg)===null||ir.origin.distanceToSquared(vg)>(e.far-e.near)**2))&&(yg.copy(r).invert(),ir.copy(e.ray).applyMatrix4(yg),!(n.boundingBox!==null&&ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ir)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],M=Math.max(m.start,f.start),b=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let _=M,I=b;_<I;_+=3){let R=a.getX(_),D=a.getX(_+1),N=a.getX(_+2);s=tc(this,p,e,n,c,h,u,R,D,N),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let M=a.getX(m),b=a.getX(m+1),_=a.getX(m+2);s=tc(this,o,e,n,c,h,u,M,b,_),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=d.length;g<v;g++){let m=d[g],p=o[m.materialIndex],M=Math.max(m.start,f.start),b=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let _=M,I=b;_<I;_+=3){let R=_,D=_+1,N=_+2;s=tc(this,p,e,n,c,h,u,R,D,N),s&&(s.faceIndex=Math.floor(_/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let m=g,p=v;m<p;m+=3){let M=m,b=m+1,_=m+2;s=tc(this,o,e,n,c,h,u,M,b,_),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Kb(i,e,t,n,s,r,o,a){let l;if(e.side===On?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===ls,a),l===null)return null;ec.copy(a),ec.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ec);return c<t.near||c>t.far?null:{distance:c,point:ec.clone(),object:i}}function tc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Kl),i.getVertexPosition(l,jl),i.getVertexPosition(c,Jl);let h=Kb(i,e,t,n,Kl,jl,Jl,_g);if(h){let u=new O;Is.getBarycoord(_g,Kl,jl,Jl,u),s&&(h.uv=Is.getInterpolatedAttribute(s,a,l,c,u,new we)),r&&(h.uv1=Is.getInterpolatedAttribute(r,a,l,c,u,new we)),o&&(h.normal=Is.getInterpolatedAttribute(o,a,l,c,u,new O),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new O,materialIndex:0};Is.getNormal(Kl,jl,Jl,d.normal),h.face=d,h.barycoord=u}return h}var Vi=class i extends Vt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new dt(c,3)),this.setAttribute("normal",new dt(h,3)),this.setAttribute("uv",new dt(u,2));function g(v,m,p,M,b,_,I,R,D,N,T){let S=_/D,C=I/N,B=_/2,V=I/2,$=R/2,X=D+1,q=N+1,Q=0,Z=0,ae=new O;for(let le=0;le<q;le++){let _e=le*C-V;for(let Me=0;Me<X;Me++){let ve=Me*S-B;ae[v]=ve*M,ae[m]=_e*b,ae[p]=$,c.push(ae.x,ae.y,ae.z),ae[v]=0,ae[m]=0,ae[p]=R>0?1:-1,h.push(ae.x,ae.y,ae.z),u.push(Me/D),u.push(1-le/N),Q+=1}}for(let le=0;le<N;le++)for(let _e=0;_e<D;_e++){let Me=d+_e+X*le,ve=d+_e+X*(le+1),rt=d+(_e+1)+X*(le+1),et=d+(_e+1)+X*le;l.push(Me,ve,et),l.push(ve,rt,et),Z+=6}a.addGroup(f,Z,T),f+=Z,d+=Q}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function wr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Rn(i){let e={};for(let t=0;t<i.length;t++){let n=wr(i[t]);for(let s in n)e[s]=n[s]}return e}function jb(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Pf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var S0={clone:wr,merge:Rn},Jb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Qb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends cs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Jb,this.fragmentShader=Qb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=wr(e.uniforms),this.uniformsGroups=jb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},ya=class extends Mn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Tt,this.projectionMatrix=new Tt,this.projectionMatrixInverse=new Tt,this.coordinateSystem=Mi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ps=new O,xg=new we,bg=new we,xn=class extends ya{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=fo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(oa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return fo*2*Math.atan(Math.tan(oa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ps.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ps.x,Ps.y).multiplyScalar(-e/Ps.z),Ps.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ps.x,Ps.y).multiplyScalar(-e/Ps.z)}getViewSize(e,t){return this.getViewBounds(e,xg,bg),t.subVectors(bg,xg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(oa*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},so=-90,ro=1,gc=class extends Mn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new xn(so,ro,e,t);s.layers=this.layers,this.add(s);let r=new xn(so,ro,e,t);r.layers=this.layers,this.add(r);let o=new xn(so,ro,e,t);o.layers=this.layers,this.add(o);let a=new xn(so,ro,e,t);a.layers=this.layers,this.add(a);let l=new xn(so,ro,e,t);l.layers=this.layers,this.add(l);let c=new xn(so,ro,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Mi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=v,e.setRenderTarget(n,5,s),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},va=class extends Zn{constructor(e=[],t=_r,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},yc=class extends zi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new va(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Vi(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:wr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:On,blending:ds});r.uniforms.tEquirect.value=t;let o=new ft(s,r),a=t.minFilter;return t.minFilter===Bs&&(t.minFilter=Si),new gc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Ct=class extends Mn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ew={type:"move"},yo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ct,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ct,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new O,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new O),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ct,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new O,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new O),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,n),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ew)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Ct;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var _a=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new Ke(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},hr=class extends Mn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Kn,this.environmentIntensity=1,this.environmentRotation=new Kn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};var Wd=new O,tw=new O,nw=new at,li=class{constructor(e=new O(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Wd.subVectors(n,t).cross(tw.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(Wd),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||nw.getNormalMatrix(e),s=this.coplanarPoint(Wd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},sr=new cr,iw=new we(.5,.5),nc=new O,vo=class{constructor(e=new li,t=new li,n=new li,s=new li,r=new li,o=new li){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Mi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],v=r[9],m=r[10],p=r[11],M=r[12],b=r[13],_=r[14],I=r[15];if(s[0].setComponents(c-o,f-h,p-g,I-M).normalize(),s[1].setComponents(c+o,f+h,p+g,I+M).normalize(),s[2].setComponents(c+a,f+u,p+v,I+b).normalize(),s[3].setComponents(c-a,f-u,p-v,I-b).normalize(),n)s[4].setComponents(l,d,m,_).normalize(),s[5].setComponents(c-l,f-d,p-m,I-_).normalize();else if(s[4].setComponents(c-l,f-d,p-m,I-_).normalize(),t===Mi)s[5].setComponents(c+l,f+d,p+m,I+_).normalize();else if(t===da)s[5].setComponents(l,d,m,_).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),sr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),sr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(sr)}intersectsSprite(e){sr.center.set(0,0,0);let t=iw.distanceTo(e.center);return sr.radius=.7071067811865476+t,sr.applyMatrix4(e.matrixWorld),this.intersectsSphere(sr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(nc.x=s.normal.x>0?e.max.x:e.min.x,nc.y=s.normal.y>0?e.max.y:e.min.y,nc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(nc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Gi=class extends cs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ke(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},vc=new O,_c=new O,wg=new Tt,sa=new Ds,ic=new cr,$d=new O,Mg=new O,ur=class extends Mn{constructor(e=new Vt,t=new Gi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)vc.fromBufferAttribute(t,s-1),_c.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=vc.distanceTo(_c);e.setAttribute("lineDistance",new dt(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ic.copy(n.boundingSphere),ic.applyMatrix4(s),ic.radius+=r,e.ray.intersectsSphere(ic)===!1)return;wg.copy(s).invert(),sa.copy(e.ray).applyMatrix4(wg);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=h.getX(v),M=h.getX(v+1),b=sc(this,e,sa,l,p,M,v);b&&t.push(b)}if(this.isLineLoop){let v=h.getX(g-1),m=h.getX(f),p=sc(this,e,sa,l,v,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let v=f,m=g-1;v<m;v+=c){let p=sc(this,e,sa,l,v,v+1,v);p&&t.push(p)}if(this.isLineLoop){let v=sc(this,e,sa,l,g-1,f,g-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function sc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(vc.fromBufferAttribute(a,s),_c.fromBufferAttribute(a,r),t.distanceSqToSegment(vc,_c,$d,Mg)>n)return;$d.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo($d);if(!(c<e.near||c>e.far))return{distance:c,point:Mg.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Sg=new O,Tg=new O,_o=class extends ur{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Sg.fromBufferAttribute(t,s),Tg.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Sg.distanceTo(Tg);e.setAttribute("lineDistance",new dt(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},xa=class extends ur{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var ba=class extends Zn{constructor(e,t,n=zs,s,r,o,a=ci,l=ci,c,h=uo,u=1){if(h!==uo&&h!==Eo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new mo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},wa=class extends Zn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var Ma=class i extends Vt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new O,h=new we;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new dt(o,3)),this.setAttribute("normal",new dt(a,3)),this.setAttribute("uv",new dt(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},Wi=class i extends Vt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,v=[],m=n/2,p=0;M(),o===!1&&(e>0&&b(!0),t>0&&b(!1)),this.setIndex(h),this.setAttribute("position",new dt(u,3)),this.setAttribute("normal",new dt(d,3)),this.setAttribute("uv",new dt(f,2));function M(){let _=new O,I=new O,R=0,D=(t-e)/n;for(let N=0;N<=r;N++){let T=[],S=N/r,C=S*(t-e)+e;for(let B=0;B<=s;B++){let V=B/s,$=V*l+a,X=Math.sin($),q=Math.cos($);I.x=C*X,I.y=-S*n+m,I.z=C*q,u.push(I.x,I.y,I.z),_.set(X,D,q).normalize(),d.push(_.x,_.y,_.z),f.push(V,1-S),T.push(g++)}v.push(T)}for(let N=0;N<s;N++)for(let T=0;T<r;T++){let S=v[T][N],C=v[T+1][N],B=v[T+1][N+1],V=v[T][N+1];(e>0||T!==0)&&(h.push(S,C,V),R+=3),(t>0||T!==r-1)&&(h.push(C,B,V),R+=3)}c.addGroup(p,R,0),p+=R}function b(_){let I=g,R=new we,D=new O,N=0,T=_===!0?e:t,S=_===!0?1:-1;for(let B=1;B<=s;B++)u.push(0,m*S,0),d.push(0,S,0),f.push(.5,.5),g++;let C=g;for(let B=0;B<=s;B++){let $=B/s*l+a,X=Math.cos($),q=Math.sin($);D.x=T*q,D.y=m*S,D.z=T*X,u.push(D.x,D.y,D.z),d.push(0,S,0),R.x=X*.5+.5,R.y=q*.5*S+.5,f.push(R.x,R.y),g++}for(let B=0;B<s;B++){let V=I+B,$=C+B;_===!0?h.push($,$+1,V):h.push($+1,$,V),N+=3}c.addGroup(p,N,_===!0?1:2),p+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Sa=class i extends Wi{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var jn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new we:new O);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new O,s=[],r=[],o=[],a=new O,l=new Tt;for(let f=0;f<=e;f++){let g=f/e;s[f]=this.getTangentAt(g,new O)}r[0]=new O,o[0]=new O;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(ct(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,g))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(ct(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],f*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},xo=class extends jn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new we){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},xc=class extends xo{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function If(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var rc=new O,Xd=new If,qd=new If,Yd=new If,bc=class extends jn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new O){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(rc.subVectors(s[0],s[1]).add(s[0]),c=rc);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(rc.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=rc),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(u),f),v=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);v<1e-4&&(v=1),g<1e-4&&(g=v),m<1e-4&&(m=v),Xd.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,g,v,m),qd.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,g,v,m),Yd.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,g,v,m)}else this.curveType==="catmullrom"&&(Xd.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),qd.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Yd.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Xd.calc(l),qd.calc(l),Yd.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new O().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Eg(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function sw(i,e){let t=1-i;return t*t*e}function rw(i,e){return 2*(1-i)*i*e}function ow(i,e){return i*i*e}function la(i,e,t,n){return sw(i,e)+rw(i,t)+ow(i,n)}function aw(i,e){let t=1-i;return t*t*t*e}function lw(i,e){let t=1-i;return 3*t*t*i*e}function cw(i,e){return 3*(1-i)*i*i*e}function hw(i,e){return i*i*i*e}function ca(i,e,t,n,s){return aw(i,e)+lw(i,t)+cw(i,n)+hw(i,s)}var Ta=class extends jn{constructor(e=new we,t=new we,n=new we,s=new we){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ca(e,s.x,r.x,o.x,a.x),ca(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},wc=class extends jn{constructor(e=new O,t=new O,n=new O,s=new O){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new O){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(ca(e,s.x,r.x,o.x,a.x),ca(e,s.y,r.y,o.y,a.y),ca(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},Ea=class extends jn{constructor(e=new we,t=new we){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new we){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new we){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Mc=class extends jn{constructor(e=new O,t=new O){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new O){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new O){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Aa=class extends jn{constructor(e=new we,t=new we,n=new we){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new we){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(la(e,s.x,r.x,o.x),la(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Sc=class extends jn{constructor(e=new O,t=new O,n=new O){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new O){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(la(e,s.x,r.x,o.x),la(e,s.y,r.y,o.y),la(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Ra=class extends jn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new we){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(Eg(a,l.x,c.x,h.x,u.x),Eg(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new we().fromArray(s))}return this}},Ag=Object.freeze({__proto__:null,ArcCurve:xc,CatmullRomCurve3:bc,CubicBezierCurve:Ta,CubicBezierCurve3:wc,EllipseCurve:xo,LineCurve:Ea,LineCurve3:Mc,QuadraticBezierCurve:Aa,QuadraticBezierCurve3:Sc,SplineCurve:Ra}),Tc=class extends jn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Ag[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new Ag[s.type]().fromJSON(s))}return this}},Ca=class extends Tc{constructor(e){super(),this.type="Path",this.currentPoint=new we,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new Ea(this.currentPoint.clone(),new we(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new Aa(this.currentPoint.clone(),new we(e,t),new we(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new Ta(this.currentPoint.clone(),new we(e,t),new we(n,s),new we(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new Ra(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new xo(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},hs=class extends Ca{constructor(e){super(e),this.uuid=br(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new Ca().fromJSON(s))}return this}};function uw(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=T0(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=gw(i,e,r,t)),i.length>80*t){a=1/0,l=1/0;let h=-1/0,u=-1/0;for(let d=t;d<s;d+=t){let f=i[d],g=i[d+1];f<a&&(a=f),g<l&&(l=g),f>h&&(h=f),g>u&&(u=g)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return Pa(r,o,t,a,l,c,0),o}function T0(i,e,t,n,s){let r;if(s===Aw(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=Rg(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=Rg(o/n|0,i[o],i[o+1],r);return r&&bo(r,r.next)&&(La(r),r=r.next),r}function dr(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(bo(t,t.next)||Kt(t.prev,t,t.next)===0)){if(La(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function Pa(i,e,t,n,s,r,o){if(!i)return;!o&&r&&bw(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?fw(i,n,s,r):dw(i)){e.push(l.i,i.i,c.i),La(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=pw(dr(i),e),Pa(i,e,t,n,s,r,2)):o===2&&mw(i,e,t,n,s,r):Pa(dr(i),e,t,n,s,r,1);break}}}function dw(i){let e=i.prev,t=i,n=i.next;if(Kt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),g=n.next;for(;g!==e;){if(g.x>=h&&g.x<=d&&g.y>=u&&g.y<=f&&ra(s,a,r,l,o,c,g.x,g.y)&&Kt(g.prev,g,g.next)>=0)return!1;g=g.next}return!0}function fw(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Kt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),g=Math.min(h,u,d),v=Math.max(a,l,c),m=Math.max(h,u,d),p=tf(f,g,e,t,n),M=tf(v,m,e,t,n),b=i.prevZ,_=i.nextZ;for(;b&&b.z>=p&&_&&_.z<=M;){if(b.x>=f&&b.x<=v&&b.y>=g&&b.y<=m&&b!==s&&b!==o&&ra(a,h,l,u,c,d,b.x,b.y)&&Kt(b.prev,b,b.next)>=0||(b=b.prevZ,_.x>=f&&_.x<=v&&_.y>=g&&_.y<=m&&_!==s&&_!==o&&ra(a,h,l,u,c,d,_.x,_.y)&&Kt(_.prev,_,_.next)>=0))return!1;_=_.nextZ}for(;b&&b.z>=p;){if(b.x>=f&&b.x<=v&&b.y>=g&&b.y<=m&&b!==s&&b!==o&&ra(a,h,l,u,c,d,b.x,b.y)&&Kt(b.prev,b,b.next)>=0)return!1;b=b.prevZ}for(;_&&_.z<=M;){if(_.x>=f&&_.x<=v&&_.y>=g&&_.y<=m&&_!==s&&_!==o&&ra(a,h,l,u,c,d,_.x,_.y)&&Kt(_.prev,_,_.next)>=0)return!1;_=_.nextZ}return!0}function pw(i,e){let t=i;do{let n=t.prev,s=t.next.next;!bo(n,s)&&A0(n,t,t.next,s)&&Ia(n,s)&&Ia(s,n)&&(e.push(n.i,t.i,s.i),La(t),La(t.next),t=i=s),t=t.next}while(t!==i);return dr(t)}function mw(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Sw(o,a)){let l=R0(o,a);o=dr(o,o.next),l=dr(l,l.next),Pa(o,e,t,n,s,r,0),Pa(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function gw(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=T0(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Mw(c))}s.sort(yw);for(let r=0;r<s.length;r++)t=vw(s[r],t);return t}function yw(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function vw(i,e){let t=_w(i,e);if(!t)return e;let n=R0(t,i);return dr(n,n.next),dr(t,t.next)}function _w(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(bo(i,t))return t;do{if(bo(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&E0(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);Ia(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&xw(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function xw(i,e){return Kt(i.prev,i,e.prev)<0&&Kt(e.next,i,i.next)<0}function bw(i,e,t,n){let s=i;do s.z===0&&(s.z=tf(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,ww(s)}function ww(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function tf(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function Mw(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function E0(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function ra(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&E0(i,e,t,n,s,r,o,a)}function Sw(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!Tw(i,e)&&(Ia(i,e)&&Ia(e,i)&&Ew(i,e)&&(Kt(i.prev,i,e.prev)||Kt(i,e.prev,e))||bo(i,e)&&Kt(i.prev,i,i.next)>0&&Kt(e.prev,e,e.next)>0)}function Kt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function bo(i,e){return i.x===e.x&&i.y===e.y}function A0(i,e,t,n){let s=ac(Kt(i,e,t)),r=ac(Kt(i,e,n)),o=ac(Kt(t,n,i)),a=ac(Kt(t,n,e));return!!(s!==r&&o!==a||s===0&&oc(i,t,e)||r===0&&oc(i,n,e)||o===0&&oc(t,i,n)||a===0&&oc(t,e,n))}function oc(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function ac(i){return i>0?1:i<0?-1:0}function Tw(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&A0(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function Ia(i,e){return Kt(i.prev,i,i.next)<0?Kt(i,e,i.next)>=0&&Kt(i,i.prev,e)>=0:Kt(i,e,i.prev)<0||Kt(i,i.next,e)<0}function Ew(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function R0(i,e){let t=nf(i.i,i.x,i.y),n=nf(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function Rg(i,e,t,n){let s=nf(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function La(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function nf(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Aw(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var sf=class{static triangulate(e,t,n=2){return uw(e,t,n)}},lo=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];Cg(e),Pg(n,e);let o=e.length;t.forEach(Cg);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,Pg(n,t[l]);let a=sf.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function Cg(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function Pg(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var fr=class i extends Vt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],v=[],m=[];for(let p=0;p<h;p++){let M=p*d-o;for(let b=0;b<c;b++){let _=b*u-r;g.push(_,-M,0),v.push(0,0,1),m.push(b/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){let b=M+c*p,_=M+c*(p+1),I=M+1+c*(p+1),R=M+1+c*p;f.push(b,_,R),f.push(_,I,R)}this.setIndex(f),this.setAttribute("position",new dt(g,3)),this.setAttribute("normal",new dt(v,3)),this.setAttribute("uv",new dt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},ka=class i extends Vt{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new O,g=new we;for(let v=0;v<=s;v++){for(let m=0;m<=n;m++){let p=r+m/n*o;f.x=u*Math.cos(p),f.y=u*Math.sin(p),l.push(f.x,f.y,f.z),c.push(0,0,1),g.x=(f.x/t+1)/2,g.y=(f.y/t+1)/2,h.push(g.x,g.y)}u+=d}for(let v=0;v<s;v++){let m=v*(n+1);for(let p=0;p<n;p++){let M=p+m,b=M,_=M+n+1,I=M+n+2,R=M+1;a.push(b,_,R),a.push(_,I,R)}}this.setIndex(a),this.setAttribute("position",new dt(l,3)),this.setAttribute("normal",new dt(c,3)),this.setAttribute("uv",new dt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}},Ns=class i extends Vt{constructor(e=new hs([new we(0,.5),new we(-.5,-.5),new we(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new dt(s,3)),this.setAttribute("normal",new dt(r,3)),this.setAttribute("uv",new dt(o,2));function c(h){let u=s.length/3,d=h.extractPoints(t),f=d.shape,g=d.holes;lo.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,p=g.length;m<p;m++){let M=g[m];lo.isClockWise(M)===!0&&(g[m]=M.reverse())}let v=lo.triangulateShape(f,g);for(let m=0,p=g.length;m<p;m++){let M=g[m];f=f.concat(M)}for(let m=0,p=f.length;m<p;m++){let M=f[m];s.push(M.x,M.y,0),r.push(0,0,1),o.push(M.x,M.y)}for(let m=0,p=v.length;m<p;m++){let M=v[m],b=M[0]+u,_=M[1]+u,I=M[2]+u;n.push(b,_,I),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return Rw(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function Rw(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var Fs=class i extends Vt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new O,d=new O,f=[],g=[],v=[],m=[];for(let p=0;p<=n;p++){let M=[],b=p/n,_=0;p===0&&o===0?_=.5/t:p===n&&l===Math.PI&&(_=-.5/t);for(let I=0;I<=t;I++){let R=I/t;u.x=-e*Math.cos(s+R*r)*Math.sin(o+b*a),u.y=e*Math.cos(o+b*a),u.z=e*Math.sin(s+R*r)*Math.sin(o+b*a),g.push(u.x,u.y,u.z),d.copy(u).normalize(),v.push(d.x,d.y,d.z),m.push(R+_,1-b),M.push(c++)}h.push(M)}for(let p=0;p<n;p++)for(let M=0;M<t;M++){let b=h[p][M+1],_=h[p][M],I=h[p+1][M],R=h[p+1][M+1];(p!==0||o>0)&&f.push(b,_,R),(p!==n-1||l<Math.PI)&&f.push(_,I,R)}this.setIndex(f),this.setAttribute("position",new dt(g,3)),this.setAttribute("normal",new dt(v,3)),this.setAttribute("uv",new dt(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var us=class extends cs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ke(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Tf,this.normalScale=new we(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Kn,this.combine=$c,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ec=class extends cs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=u0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ac=class extends cs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function lc(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Cw(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var pr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Rc=class extends pr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Kd,endingEnd:Kd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case jd:r=e,a=2*t-n;break;case Jd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case jd:o=e,l=2*n-t;break;case Jd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),v=g*g,m=v*g,p=-d*m+2*d*v-d*g,M=(1+d)*m+(-1.5-2*d)*v+(-.5+d)*g+1,b=(-1-f)*m+(1.5+f)*v+.5*g,_=f*m-f*v;for(let I=0;I!==a;++I)r[I]=p*o[h+I]+M*o[c+I]+b*o[l+I]+_*o[u+I];return r}},Cc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Pc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Jn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=lc(t,this.TimeBufferType),this.values=lc(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:lc(e.times,Array),values:lc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Cc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Rc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case ha:t=this.InterpolantFactoryMethodDiscrete;break;case dc:t=this.InterpolantFactoryMethodLinear;break;case cc:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ha;case this.InterpolantFactoryMethodLinear:return dc;case this.InterpolantFactoryMethodSmooth:return cc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Cw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===cc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let v=t[u+g];if(v!==t[d+g]||v!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Jn.prototype.ValueTypeName="";Jn.prototype.TimeBufferType=Float32Array;Jn.prototype.ValueBufferType=Float32Array;Jn.prototype.DefaultInterpolation=dc;var Us=class extends Jn{constructor(e,t,n){super(e,t,n)}};Us.prototype.ValueTypeName="bool";Us.prototype.ValueBufferType=Array;Us.prototype.DefaultInterpolation=ha;Us.prototype.InterpolantFactoryMethodLinear=void 0;Us.prototype.InterpolantFactoryMethodSmooth=void 0;var Ic=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};Ic.prototype.ValueTypeName="color";var Lc=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};Lc.prototype.ValueTypeName="number";var kc=class extends pr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)en.slerpFlat(r,0,o,c-a,o,c,l);return r}},Da=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new kc(this.times,this.values,this.getValueSize(),e)}};Da.prototype.ValueTypeName="quaternion";Da.prototype.InterpolantFactoryMethodSmooth=void 0;var Os=class extends Jn{constructor(e,t,n){super(e,t,n)}};Os.prototype.ValueTypeName="string";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=ha;Os.prototype.InterpolantFactoryMethodLinear=void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var Dc=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};Dc.prototype.ValueTypeName="vector";var rf={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(this.files[i]=e)},get:function(i){if(this.enabled!==!1)return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}},Nc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},C0=new Nc,mr=class{constructor(e){this.manager=e!==void 0?e:C0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};mr.DEFAULT_MATERIAL_NAME="__DEFAULT";var os={},of=class extends Error{constructor(e,t){super(e),this.response=t}},Na=class extends mr{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=rf.get(`file:${e}`);if(r!==void 0)return this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0),r;if(os[e]!==void 0){os[e].push({onLoad:t,onProgress:n,onError:s});return}os[e]=[],os[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&console.warn("THREE.FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let h=os[e],u=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,v=0,m=new ReadableStream({start(p){M();function M(){u.read().then(({done:b,value:_})=>{if(b)p.close();else{v+=_.byteLength;let I=new ProgressEvent("progress",{lengthComputable:g,loaded:v,total:f});for(let R=0,D=h.length;R<D;R++){let N=h[R];N.onProgress&&N.onProgress(I)}p.enqueue(_),M()}},b=>{p.error(b)})}}});return new Response(m)}else throw new of(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return c.json();default:if(a==="")return c.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),d=u&&u[1]?u[1].toLowerCase():void 0,f=new TextDecoder(d);return c.arrayBuffer().then(g=>f.decode(g))}}}).then(c=>{rf.add(`file:${e}`,c);let h=os[e];delete os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onLoad&&f.onLoad(c)}}).catch(c=>{let h=os[e];if(h===void 0)throw this.manager.itemError(e),c;delete os[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onError&&f.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Fa=class extends Mn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ke(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},gr=class extends Fa{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Mn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ke(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},Zd=new Tt,Ig=new O,Lg=new O,af=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new we(512,512),this.mapType=Ri,this.map=null,this.mapPass=null,this.matrix=new Tt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new vo,this._frameExtents=new we(1,1),this._viewportCount=1,this._viewports=[new jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;Ig.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ig),Lg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Lg),t.updateMatrixWorld(),Zd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Zd,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Zd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Ua=class extends ya{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},lf=class extends af{constructor(){super(new Ua(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},yr=class extends Fa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Mn.DEFAULT_UP),this.updateMatrix(),this.target=new Mn,this.shadow=new lf}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var Fc=class extends xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Lf="\\[\\]\\.:\\/",Pw=new RegExp("["+Lf+"]","g"),kf="[^"+Lf+"]",Iw="[^"+Lf.replace("\\.","")+"]",Lw=/((?:WC+[\/:])*)/.source.replace("WC",kf),kw=/(WCOD+)?/.source.replace("WCOD",Iw),Dw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",kf),Nw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",kf),Fw=new RegExp("^"+Lw+kw+Dw+Nw+"$"),Uw=["material","materials","bones","map"],cf=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Pw,"")}static parseTrackName(e){let t=Fw.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Uw.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=cf;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var z2=new Float32Array(1);var kg=new Tt,Oa=class{constructor(e,t,n=0,s=1/0){this.ray=new Ds(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new go,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return kg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(kg),this}intersectObject(e,t=!0,n=[]){return hf(e,this,n,t),n.sort(Dg),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)hf(e[s],this,n,t);return n.sort(Dg),n}};function Dg(i,e){return i.distance-e.distance}function hf(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)hf(r[o],e,t,!0)}}var wo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var vr=class extends _o{constructor(e=10,t=10,n=4473924,s=8947848){n=new Ke(n),s=new Ke(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let v=d===r?n:s;v.toArray(c,f),f+=3,v.toArray(c,f),f+=3,v.toArray(c,f),f+=3,v.toArray(c,f),f+=3}let h=new Vt;h.setAttribute("position",new dt(l,3)),h.setAttribute("color",new dt(c,3));let u=new Gi({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){this.geometry.dispose(),this.material.dispose()}};var Ba=class extends Bi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Df(i,e,t,n){let s=Ow(n);switch(t){case bf:return i*e;case Mf:return i*e/s.components*s.byteLength;case Jc:return i*e/s.components*s.byteLength;case Sf:return i*e*2/s.components*s.byteLength;case Qc:return i*e*2/s.components*s.byteLength;case wf:return i*e*3/s.components*s.byteLength;case ui:return i*e*4/s.components*s.byteLength;case eh:return i*e*4/s.components*s.byteLength;case Va:case Ga:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Wa:case $a:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nh:case sh:return Math.max(i,16)*Math.max(e,8)/4;case th:case ih:return Math.max(i,8)*Math.max(e,8)/2;case rh:case oh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ah:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ch:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case hh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case uh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case dh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case fh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case ph:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case gh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case yh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case vh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case bh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case wh:case Mh:case Sh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Th:case Eh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ah:case Rh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Ow(i){switch(i){case Ri:case yf:return{byteLength:1,components:1};case Mo:case vf:case So:return{byteLength:2,components:1};case Kc:case jc:return{byteLength:2,components:4};case zs:case Zc:case Xi:return{byteLength:4,components:1};case _f:case xf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Q0(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function zw(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],v=u[f];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++d,u[d]=v)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let v=u[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Hw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Vw=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Gw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ww=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$w=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Xw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,qw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Yw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Zw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Kw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,jw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Jw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Qw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,eM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,tM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,nM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,iM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,sM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,rM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,oM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,aM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,lM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,cM=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,hM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,uM=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,dM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,fM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,pM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,mM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,gM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yM="gl_FragColor = linearToOutputTexel( gl_FragColor );",vM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_M=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,xM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,bM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,wM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,MM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,SM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,TM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,EM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,AM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,RM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,CM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,PM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,IM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,LM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,kM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,DM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,NM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,FM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,UM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,OM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,BM=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,zM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,HM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,VM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,GM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,WM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$M=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,XM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,qM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,YM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ZM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,KM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,JM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,QM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,eS=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,tS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nS=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,iS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,rS=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,oS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,aS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,lS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,cS=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,hS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,uS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,dS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,fS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,pS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,mS=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,gS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,vS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,_S=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,xS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,bS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,wS=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,MS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,SS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,TS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ES=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,AS=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,RS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,CS=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,PS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,IS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,LS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,kS=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,DS=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,NS=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,FS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,US=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,OS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,BS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,zS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,HS=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GS=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$S=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,XS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,qS=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,YS=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ZS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,KS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,jS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,JS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,eT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,tT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,iT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,rT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,oT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,aT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,lT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,cT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,uT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,pT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,mT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,gT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,vT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,_T=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:Hw,alphahash_pars_fragment:Vw,alphamap_fragment:Gw,alphamap_pars_fragment:Ww,alphatest_fragment:$w,alphatest_pars_fragment:Xw,aomap_fragment:qw,aomap_pars_fragment:Yw,batching_pars_vertex:Zw,batching_vertex:Kw,begin_vertex:jw,beginnormal_vertex:Jw,bsdfs:Qw,iridescence_fragment:eM,bumpmap_pars_fragment:tM,clipping_planes_fragment:nM,clipping_planes_pars_fragment:iM,clipping_planes_pars_vertex:sM,clipping_planes_vertex:rM,color_fragment:oM,color_pars_fragment:aM,color_pars_vertex:lM,color_vertex:cM,common:hM,cube_uv_reflection_fragment:uM,defaultnormal_vertex:dM,displacementmap_pars_vertex:fM,displacementmap_vertex:pM,emissivemap_fragment:mM,emissivemap_pars_fragment:gM,colorspace_fragment:yM,colorspace_pars_fragment:vM,envmap_fragment:_M,envmap_common_pars_fragment:xM,envmap_pars_fragment:bM,envmap_pars_vertex:wM,envmap_physical_pars_fragment:kM,envmap_vertex:MM,fog_vertex:SM,fog_pars_vertex:TM,fog_fragment:EM,fog_pars_fragment:AM,gradientmap_pars_fragment:RM,lightmap_pars_fragment:CM,lights_lambert_fragment:PM,lights_lambert_pars_fragment:IM,lights_pars_begin:LM,lights_toon_fragment:DM,lights_toon_pars_fragment:NM,lights_phong_fragment:FM,lights_phong_pars_fragment:UM,lights_physical_fragment:OM,lights_physical_pars_fragment:BM,lights_fragment_begin:zM,lights_fragment_maps:HM,lights_fragment_end:VM,logdepthbuf_fragment:GM,logdepthbuf_pars_fragment:WM,logdepthbuf_pars_vertex:$M,logdepthbuf_vertex:XM,map_fragment:qM,map_pars_fragment:YM,map_particle_fragment:ZM,map_particle_pars_fragment:KM,metalnessmap_fragment:jM,metalnessmap_pars_fragment:JM,morphinstance_vertex:QM,morphcolor_vertex:eS,morphnormal_vertex:tS,morphtarget_pars_vertex:nS,morphtarget_vertex:iS,normal_fragment_begin:sS,normal_fragment_maps:rS,normal_pars_fragment:oS,normal_pars_vertex:aS,normal_vertex:lS,normalmap_pars_fragment:cS,clearcoat_normal_fragment_begin:hS,clearcoat_normal_fragment_maps:uS,clearcoat_pars_fragment:dS,iridescence_pars_fragment:fS,opaque_fragment:pS,packing:mS,premultiplied_alpha_fragment:gS,project_vertex:yS,dithering_fragment:vS,dithering_pars_fragment:_S,roughnessmap_fragment:xS,roughnessmap_pars_fragment:bS,shadowmap_pars_fragment:wS,shadowmap_pars_vertex:MS,shadowmap_vertex:SS,shadowmask_pars_fragment:TS,skinbase_vertex:ES,skinning_pars_vertex:AS,skinning_vertex:RS,skinnormal_vertex:CS,specularmap_fragment:PS,specularmap_pars_fragment:IS,tonemapping_fragment:LS,tonemapping_pars_fragment:kS,transmission_fragment:DS,transmission_pars_fragment:NS,uv_pars_fragment:FS,uv_pars_vertex:US,uv_vertex:OS,worldpos_vertex:BS,background_vert:zS,background_frag:HS,backgroundCube_vert:VS,backgroundCube_frag:GS,cube_vert:WS,cube_frag:$S,depth_vert:XS,depth_frag:qS,distanceRGBA_vert:YS,distanceRGBA_frag:ZS,equirect_vert:KS,equirect_frag:jS,linedashed_vert:JS,linedashed_frag:QS,meshbasic_vert:eT,meshbasic_frag:tT,meshlambert_vert:nT,meshlambert_frag:iT,meshmatcap_vert:sT,meshmatcap_frag:rT,meshnormal_vert:oT,meshnormal_frag:aT,meshphong_vert:lT,meshphong_frag:cT,meshphysical_vert:hT,meshphysical_frag:uT,meshtoon_vert:dT,meshtoon_frag:fT,points_vert:pT,points_frag:mT,shadow_vert:gT,shadow_frag:yT,sprite_vert:vT,sprite_frag:_T},Te={common:{diffuse:{value:new Ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new at}},envmap:{envMap:{value:null},envMapRotation:{value:new at},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new at}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new at}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new at},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new at},normalScale:{value:new we(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new at},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new at}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new at}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new at}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0},uvTransform:{value:new at}},sprite:{diffuse:{value:new Ke(16777215)},opacity:{value:1},center:{value:new we(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new at},alphaMap:{value:null},alphaMapTransform:{value:new at},alphaTest:{value:0}}},qi={basic:{uniforms:Rn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Rn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new Ke(0)}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Rn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new Ke(0)},specular:{value:new Ke(1118481)},shininess:{value:30}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Rn([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new Ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Rn([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new Ke(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Rn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Rn([Te.points,Te.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Rn([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Rn([Te.common,Te.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Rn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Rn([Te.sprite,Te.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new at},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new at}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distanceRGBA:{uniforms:Rn([Te.common,Te.displacementmap,{referencePosition:{value:new O},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distanceRGBA_vert,fragmentShader:ht.distanceRGBA_frag},shadow:{uniforms:Rn([Te.lights,Te.fog,{color:{value:new Ke(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};qi.physical={uniforms:Rn([qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new at},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new at},clearcoatNormalScale:{value:new we(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new at},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new at},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new at},sheen:{value:0},sheenColor:{value:new Ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new at},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new at},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new at},transmissionSamplerSize:{value:new we},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new at},attenuationDistance:{value:0},attenuationColor:{value:new Ke(0)},specularColor:{value:new Ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new at},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new at},anisotropyVector:{value:new we},anisotropyMap:{value:null},anisotropyMapTransform:{value:new at}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Ch={r:0,b:0,g:0},Mr=new Kn,xT=new Tt;function bT(i,e,t,n,s,r,o){let a=new Ke(0),l=r===!0?0:1,c,h,u=null,d=0,f=null;function g(b){let _=b.isScene===!0?b.background:null;return _&&_.isTexture&&(_=(b.backgroundBlurriness>0?t:e).get(_)),_}function v(b){let _=!1,I=g(b);I===null?p(a,l):I&&I.isColor&&(p(I,1),_=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?n.buffers.color.setClear(0,0,0,1,o):R==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||_)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(b,_){let I=g(_);I&&(I.isCubeTexture||I.mapping===za)?(h===void 0&&(h=new ft(new Vi(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:wr(qi.backgroundCube.uniforms),vertexShader:qi.backgroundCube.vertexShader,fragmentShader:qi.backgroundCube.fragmentShader,side:On,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(R,D,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Mr.copy(_.backgroundRotation),Mr.x*=-1,Mr.y*=-1,Mr.z*=-1,I.isCubeTexture&&I.isRenderTargetTexture===!1&&(Mr.y*=-1,Mr.z*=-1),h.material.uniforms.envMap.value=I,h.material.uniforms.flipEnvMap.value=I.isCubeTexture&&I.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(xT.makeRotationFromEuler(Mr)),h.material.toneMapped=yt.getTransfer(I.colorSpace)!==Pt,(u!==I||d!==I.version||f!==i.toneMapping)&&(h.material.needsUpdate=!0,u=I,d=I.version,f=i.toneMapping),h.layers.enableAll(),b.unshift(h,h.geometry,h.material,0,0,null)):I&&I.isTexture&&(c===void 0&&(c=new ft(new fr(2,2),new Ti({name:"BackgroundMaterial",uniforms:wr(qi.background.uniforms),vertexShader:qi.background.vertexShader,fragmentShader:qi.background.fragmentShader,side:ls,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=I,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.toneMapped=yt.getTransfer(I.colorSpace)!==Pt,I.matrixAutoUpdate===!0&&I.updateMatrix(),c.material.uniforms.uvTransform.value.copy(I.matrix),(u!==I||d!==I.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=I,d=I.version,f=i.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null))}function p(b,_){b.getRGB(Ch,Pf(i)),n.buffers.color.setClear(Ch.r,Ch.g,Ch.b,_,o)}function M(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(b,_=1){a.set(b),l=_,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(b){l=b,p(a,l)},render:v,addToRenderList:m,dispose:M}}function wT(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(S,C,B,V,$){let X=!1,q=u(V,B,C);r!==q&&(r=q,c(r.object)),X=f(S,V,B,$),X&&g(S,V,B,$),$!==null&&e.update($,i.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,_(S,C,B,V),$!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get($).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,C,B){let V=B.wireframe===!0,$=n[S.id];$===void 0&&($={},n[S.id]=$);let X=$[C.id];X===void 0&&(X={},$[C.id]=X);let q=X[V];return q===void 0&&(q=d(l()),X[V]=q),q}function d(S){let C=[],B=[],V=[];for(let $=0;$<t;$++)C[$]=0,B[$]=0,V[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:B,attributeDivisors:V,object:S,attributes:{},index:null}}function f(S,C,B,V){let $=r.attributes,X=C.attributes,q=0,Q=B.getAttributes();for(let Z in Q)if(Q[Z].location>=0){let le=$[Z],_e=X[Z];if(_e===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(_e=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(_e=S.instanceColor)),le===void 0||le.attribute!==_e||_e&&le.data!==_e.data)return!0;q++}return r.attributesNum!==q||r.index!==V}function g(S,C,B,V){let $={},X=C.attributes,q=0,Q=B.getAttributes();for(let Z in Q)if(Q[Z].location>=0){let le=X[Z];le===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(le=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(le=S.instanceColor));let _e={};_e.attribute=le,le&&le.data&&(_e.data=le.data),$[Z]=_e,q++}r.attributes=$,r.attributesNum=q,r.index=V}function v(){let S=r.newAttributes;for(let C=0,B=S.length;C<B;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){let B=r.newAttributes,V=r.enabledAttributes,$=r.attributeDivisors;B[S]=1,V[S]===0&&(i.enableVertexAttribArray(S),V[S]=1),$[S]!==C&&(i.vertexAttribDivisor(S,C),$[S]=C)}function M(){let S=r.newAttributes,C=r.enabledAttributes;for(let B=0,V=C.length;B<V;B++)C[B]!==S[B]&&(i.disableVertexAttribArray(B),C[B]=0)}function b(S,C,B,V,$,X,q){q===!0?i.vertexAttribIPointer(S,C,B,$,X):i.vertexAttribPointer(S,C,B,V,$,X)}function _(S,C,B,V){v();let $=V.attributes,X=B.getAttributes(),q=C.defaultAttributeValues;for(let Q in X){let Z=X[Q];if(Z.location>=0){let ae=$[Q];if(ae===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ae=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ae=S.instanceColor)),ae!==void 0){let le=ae.normalized,_e=ae.itemSize,Me=e.get(ae);if(Me===void 0)continue;let ve=Me.buffer,rt=Me.type,et=Me.bytesPerElement,ee=rt===i.INT||rt===i.UNSIGNED_INT||ae.gpuType===Zc;if(ae.isInterleavedBufferAttribute){let ne=ae.data,Ee=ne.stride,Ve=ae.offset;if(ne.isInstancedInterleavedBuffer){for(let xe=0;xe<Z.locationSize;xe++)p(Z.location+xe,ne.meshPerAttribute);S.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let xe=0;xe<Z.locationSize;xe++)m(Z.location+xe);i.bindBuffer(i.ARRAY_BUFFER,ve);for(let xe=0;xe<Z.locationSize;xe++)b(Z.location+xe,_e/Z.locationSize,rt,le,Ee*et,(Ve+_e/Z.locationSize*xe)*et,ee)}else{if(ae.isInstancedBufferAttribute){for(let ne=0;ne<Z.locationSize;ne++)p(Z.location+ne,ae.meshPerAttribute);S.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let ne=0;ne<Z.locationSize;ne++)m(Z.location+ne);i.bindBuffer(i.ARRAY_BUFFER,ve);for(let ne=0;ne<Z.locationSize;ne++)b(Z.location+ne,_e/Z.locationSize,rt,le,_e*et,_e/Z.locationSize*ne*et,ee)}}else if(q!==void 0){let le=q[Q];if(le!==void 0)switch(le.length){case 2:i.vertexAttrib2fv(Z.location,le);break;case 3:i.vertexAttrib3fv(Z.location,le);break;case 4:i.vertexAttrib4fv(Z.location,le);break;default:i.vertexAttrib1fv(Z.location,le)}}}}M()}function I(){N();for(let S in n){let C=n[S];for(let B in C){let V=C[B];for(let $ in V)h(V[$].object),delete V[$];delete C[B]}delete n[S]}}function R(S){if(n[S.id]===void 0)return;let C=n[S.id];for(let B in C){let V=C[B];for(let $ in V)h(V[$].object),delete V[$];delete C[B]}delete n[S.id]}function D(S){for(let C in n){let B=n[C];if(B[S.id]===void 0)continue;let V=B[S.id];for(let $ in V)h(V[$].object),delete V[$];delete B[S.id]}}function N(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:T,dispose:I,releaseStatesOfGeometry:R,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:M}}function MT(i,e,t){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),t.update(h,n,u))}function a(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let f=0;for(let g=0;g<u;g++)f+=h[g];t.update(f,n,1)}function l(c,h,u,d){if(u===0)return;let f=e.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<c.length;g++)o(c[g],h[g],d[g]);else{f.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let g=0;for(let v=0;v<u;v++)g+=h[v]*d[v];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function ST(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let D=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ui&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let N=D===So&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Ri&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Xi&&!N)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),_=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),I=g>0,R=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:M,maxVaryings:b,maxFragmentUniforms:_,vertexTextures:I,maxSamples:R}}function TT(i){let e=this,t=null,n=0,s=!1,r=!1,o=new li,a=new at,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,v=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let M=r?0:n,b=M*4,_=p.clippingState||null;l.value=_,_=h(g,d,b,f);for(let I=0;I!==b;++I)_[I]=t[I];p.clippingState=_,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let v=u!==null?u.length:0,m=null;if(v!==0){if(m=l.value,g!==!0||m===null){let p=f+v*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<p)&&(m=new Float32Array(p));for(let b=0,_=f;b!==v;++b,_+=4)o.copy(u[b]).applyMatrix4(M,a),o.normal.toArray(m,_),m[_+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}function ET(i){let e=new WeakMap;function t(o,a){return a===Xc?o.mapping=_r:a===qc&&(o.mapping=xr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Xc||a===qc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new yc(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var Ro=4,P0=[.125,.215,.35,.446,.526,.582],Er=20,Nf=new Ua,I0=new Ke,Ff=null,Uf=0,Of=0,Bf=!1,Tr=(1+Math.sqrt(5))/2,Ao=1/Tr,L0=[new O(-Tr,Ao,0),new O(Tr,Ao,0),new O(-Ao,0,Tr),new O(Ao,0,Tr),new O(0,Tr,-Ao),new O(0,Tr,Ao),new O(-1,1,-1),new O(1,1,-1),new O(-1,1,1),new O(1,1,1)],AT=new O,Lh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=AT}=r;Ff=this._renderer.getRenderTarget(),Uf=this._renderer.getActiveCubeFace(),Of=this._renderer.getActiveMipmapLevel(),Bf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=N0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=D0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Ff,Uf,Of),this._renderer.xr.enabled=Bf,e.scissorTest=!1,Ph(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===_r||e.mapping===xr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Ff=this._renderer.getRenderTarget(),Uf=this._renderer.getActiveCubeFace(),Of=this._renderer.getActiveMipmapLevel(),Bf=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:Si,minFilter:Si,generateMipmaps:!1,type:So,format:ui,colorSpace:lr,depthBuffer:!1},s=k0(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=k0(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=RT(r)),this._blurMaterial=CT(r,e,t)}return s}_compileMaterial(e){let t=new ft(this._lodPlanes[0],e);this._renderer.compile(t,Nf)}_sceneToCubeUV(e,t,n,s,r){let l=new xn(90,1,t,n),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],u=this._renderer,d=u.autoClear,f=u.toneMapping;u.getClearColor(I0),u.toneMapping=fs,u.autoClear=!1,u.state.buffers.depth.getReversed()&&(u.setRenderTarget(s),u.clearDepth(),u.setRenderTarget(null));let v=new An({name:"PMREM.Background",side:On,depthWrite:!1,depthTest:!1}),m=new ft(new Vi,v),p=!1,M=e.background;M?M.isColor&&(v.color.copy(M),e.background=null,p=!0):(v.color.copy(I0),p=!0);for(let b=0;b<6;b++){let _=b%3;_===0?(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[b],r.y,r.z)):_===1?(l.up.set(0,0,c[b]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[b],r.z)):(l.up.set(0,c[b],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[b]));let I=this._cubeSize;Ph(s,_*I,b>2?I:0,I,I),u.setRenderTarget(s),p&&u.render(m,l),u.render(e,l)}m.geometry.dispose(),m.material.dispose(),u.toneMapping=f,u.autoClear=d,e.background=M}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===_r||e.mapping===xr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=N0()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=D0());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new ft(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;Ph(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,Nf)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=L0[(s-r-1)%L0.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new ft(this._lodPlanes[s],c),d=c.uniforms,f=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*Er-1),v=r/g,m=isFinite(r)?1+Math.floor(h*v):Er;m>Er&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Er}`);let p=[],M=0;for(let D=0;D<Er;++D){let N=D/v,T=Math.exp(-N*N/2);p.push(T),D===0?M+=T:D<m&&(M+=2*T)}for(let D=0;D<p.length;D++)p[D]=p[D]/M;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);let{_lodMax:b}=this;d.dTheta.value=g,d.mipInt.value=b-n;let _=this._sizeLods[s],I=3*_*(s>b-Ro?s-b+Ro:0),R=4*(this._cubeSize-_);Ph(t,I,R,3*_,2*_),l.setRenderTarget(t),l.render(u,Nf)}};function RT(i){let e=[],t=[],n=[],s=i,r=i-Ro+1+P0.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-Ro?l=P0[o-i+Ro-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],f=6,g=6,v=3,m=2,p=1,M=new Float32Array(v*g*f),b=new Float32Array(m*g*f),_=new Float32Array(p*g*f);for(let R=0;R<f;R++){let D=R%3*2/3-1,N=R>2?0:-1,T=[D,N,0,D+2/3,N,0,D+2/3,N+1,0,D,N,0,D+2/3,N+1,0,D,N+1,0];M.set(T,v*g*R),b.set(d,m*g*R);let S=[R,R,R,R,R,R];_.set(S,p*g*R)}let I=new Vt;I.setAttribute("position",new on(M,v)),I.setAttribute("uv",new on(b,m)),I.setAttribute("faceIndex",new on(_,p)),e.push(I),s>Ro&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function k0(i,e,t){let n=new zi(i,e,t);return n.texture.mapping=za,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function Ph(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function CT(i,e,t){let n=new Float32Array(Er),s=new O(0,1,0);return new Ti({name:"SphericalGaussianBlur",defines:{n:Er,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function D0(){return new Ti({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function N0(){return new Ti({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Zf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ds,depthTest:!1,depthWrite:!1})}function Zf(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function PT(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Xc||l===qc,h=l===_r||l===xr;if(c||h){let u=e.get(a),d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new Lh(i)),u=c?t.fromEquirectangular(a,u):t.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),u.texture;if(u!==void 0)return u.texture;{let f=a.image;return c&&f&&f.height>0||h&&f&&s(f)?(t===null&&(t=new Lh(i)),u=c?t.fromEquirectangular(a):t.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function IT(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&po("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function LT(i,e,t,n){let s={},r=new WeakMap;function o(u){let d=u.target;d.index!==null&&e.remove(d.index);for(let g in d.attributes)e.remove(d.attributes[g]);d.removeEventListener("dispose",o),delete s[d.id];let f=r.get(d);f&&(e.remove(f),r.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(u){let d=u.attributes;for(let f in d)e.update(d[f],i.ARRAY_BUFFER)}function c(u){let d=[],f=u.index,g=u.attributes.position,v=0;if(f!==null){let M=f.array;v=f.version;for(let b=0,_=M.length;b<_;b+=3){let I=M[b+0],R=M[b+1],D=M[b+2];d.push(I,R,R,D,D,I)}}else if(g!==void 0){let M=g.array;v=g.version;for(let b=0,_=M.length/3-1;b<_;b+=3){let I=b+0,R=b+1,D=b+2;d.push(I,R,R,D,D,I)}}else return;let m=new(Cf(d)?ga:ma)(d,1);m.version=v;let p=r.get(u);p&&e.remove(p),r.set(u,m)}function h(u){let d=r.get(u);if(d){let f=u.index;f!==null&&d.version<f.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function kT(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,f){i.drawElements(n,f,r,d*o),t.update(f,n,1)}function c(d,f,g){g!==0&&(i.drawElementsInstanced(n,f,r,d*o,g),t.update(f,n,g))}function h(d,f,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,d,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];t.update(m,n,1)}function u(d,f,g,v){if(g===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)c(d[p]/o,f[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(n,f,0,r,d,0,v,0,g);let p=0;for(let M=0;M<g;M++)p+=f[M]*v[M];t.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function DT(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function NT(i,e,t){let n=new WeakMap,s=new jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let T=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],b=0;f===!0&&(b=1),g===!0&&(b=2),v===!0&&(b=3);let _=a.attributes.position.count*b,I=1;_>e.maxTextureSize&&(I=Math.ceil(_/e.maxTextureSize),_=e.maxTextureSize);let R=new Float32Array(_*I*4*u),D=new pa(R,_,I,u);D.type=Xi,D.needsUpdate=!0;let N=b*4;for(let S=0;S<u;S++){let C=m[S],B=p[S],V=M[S],$=_*I*4*S;for(let X=0;X<C.count;X++){let q=X*N;f===!0&&(s.fromBufferAttribute(C,X),R[$+q+0]=s.x,R[$+q+1]=s.y,R[$+q+2]=s.z,R[$+q+3]=0),g===!0&&(s.fromBufferAttribute(B,X),R[$+q+4]=s.x,R[$+q+5]=s.y,R[$+q+6]=s.z,R[$+q+7]=0),v===!0&&(s.fromBufferAttribute(V,X),R[$+q+8]=s.x,R[$+q+9]=s.y,R[$+q+10]=s.z,R[$+q+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:D,size:new we(_,I)},n.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function FT(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var ey=new Zn,F0=new ba(1,1),ty=new pa,ny=new mc,iy=new va,U0=[],O0=[],B0=new Float32Array(16),z0=new Float32Array(9),H0=new Float32Array(4);function Io(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=U0[s];if(r===void 0&&(r=new Float32Array(s),U0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function an(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function ln(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function kh(i,e){let t=O0[e];t===void 0&&(t=new Int32Array(e),O0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function UT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function OT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2fv(this.addr,e),ln(t,e)}}function BT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(an(t,e))return;i.uniform3fv(this.addr,e),ln(t,e)}}function zT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4fv(this.addr,e),ln(t,e)}}function HT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;H0.set(n),i.uniformMatrix2fv(this.addr,!1,H0),ln(t,n)}}function VT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;z0.set(n),i.uniformMatrix3fv(this.addr,!1,z0),ln(t,n)}}function GT(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;B0.set(n),i.uniformMatrix4fv(this.addr,!1,B0),ln(t,n)}}function WT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function $T(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2iv(this.addr,e),ln(t,e)}}function XT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3iv(this.addr,e),ln(t,e)}}function qT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4iv(this.addr,e),ln(t,e)}}function YT(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function ZT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2uiv(this.addr,e),ln(t,e)}}function KT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3uiv(this.addr,e),ln(t,e)}}function jT(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4uiv(this.addr,e),ln(t,e)}}function JT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(F0.compareFunction=Ef,r=F0):r=ey,t.setTexture2D(e||r,s)}function QT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||ny,s)}function eE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||iy,s)}function tE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||ty,s)}function nE(i){switch(i){case 5126:return UT;case 35664:return OT;case 35665:return BT;case 35666:return zT;case 35674:return HT;case 35675:return VT;case 35676:return GT;case 5124:case 35670:return WT;case 35667:case 35671:return $T;case 35668:case 35672:return XT;case 35669:case 35673:return qT;case 5125:return YT;case 36294:return ZT;case 36295:return KT;case 36296:return jT;case 35678:case 36198:case 36298:case 36306:case 35682:return JT;case 35679:case 36299:case 36307:return QT;case 35680:case 36300:case 36308:case 36293:return eE;case 36289:case 36303:case 36311:case 36292:return tE}}function iE(i,e){i.uniform1fv(this.addr,e)}function sE(i,e){let t=Io(e,this.size,2);i.uniform2fv(this.addr,t)}function rE(i,e){let t=Io(e,this.size,3);i.uniform3fv(this.addr,t)}function oE(i,e){let t=Io(e,this.size,4);i.uniform4fv(this.addr,t)}function aE(i,e){let t=Io(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function lE(i,e){let t=Io(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function cE(i,e){let t=Io(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function hE(i,e){i.uniform1iv(this.addr,e)}function uE(i,e){i.uniform2iv(this.addr,e)}function dE(i,e){i.uniform3iv(this.addr,e)}function fE(i,e){i.uniform4iv(this.addr,e)}function pE(i,e){i.uniform1uiv(this.addr,e)}function mE(i,e){i.uniform2uiv(this.addr,e)}function gE(i,e){i.uniform3uiv(this.addr,e)}function yE(i,e){i.uniform4uiv(this.addr,e)}function vE(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||ey,r[o])}function _E(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ny,r[o])}function xE(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||iy,r[o])}function bE(i,e,t){let n=this.cache,s=e.length,r=kh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ty,r[o])}function wE(i){switch(i){case 5126:return iE;case 35664:return sE;case 35665:return rE;case 35666:return oE;case 35674:return aE;case 35675:return lE;case 35676:return cE;case 5124:case 35670:return hE;case 35667:case 35671:return uE;case 35668:case 35672:return dE;case 35669:case 35673:return fE;case 5125:return pE;case 36294:return mE;case 36295:return gE;case 36296:return yE;case 35678:case 36198:case 36298:case 36306:case 35682:return vE;case 35679:case 36299:case 36307:return _E;case 35680:case 36300:case 36308:case 36293:return xE;case 36289:case 36303:case 36311:case 36292:return bE}}var Hf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=nE(t.type)}},Vf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=wE(t.type)}},Gf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},zf=/(\w+)(\])?(\[|\.)?/g;function V0(i,e){i.seq.push(e),i.map[e.id]=e}function ME(i,e,t){let n=i.name,s=n.length;for(zf.lastIndex=0;;){let r=zf.exec(n),o=zf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){V0(t,c===void 0?new Hf(a,i,e):new Vf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Gf(a),V0(t,u)),t=u}}}var Co=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);ME(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function G0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var SE=37297,TE=0;function EE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var W0=new at;function AE(i){yt._getMatrix(W0,yt.workingColorSpace,i);let e=`mat3( ${W0.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(i)){case ua:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function $0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+EE(i.getShaderSource(e),a)}else return r}function RE(i,e){let t=AE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function CE(i,e){let t;switch(e){case i0:t="Linear";break;case s0:t="Reinhard";break;case r0:t="Cineon";break;case o0:t="ACESFilmic";break;case l0:t="AgX";break;case c0:t="Neutral";break;case a0:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ih=new O;function PE(){yt.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),e=Ih.y.toFixed(4),t=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function IE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(qa).join(`
`)}function LE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function kE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function qa(i){return i!==""}function X0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function q0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var DE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Wf(i){return i.replace(DE,FE)}var NE=new Map;function FE(i,e){let t=ht[e];if(t===void 0){let n=NE.get(e);if(n!==void 0)t=ht[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return Wf(t)}var UE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Y0(i){return i.replace(UE,OE)}function OE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Z0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function BE(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===df?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Ug?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===$i&&(e="SHADOWMAP_TYPE_VSM"),e}function zE(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case _r:case xr:e="ENVMAP_TYPE_CUBE";break;case za:e="ENVMAP_TYPE_CUBE_UV";break}return e}function HE(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case xr:e="ENVMAP_MODE_REFRACTION";break}return e}function VE(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case $c:e="ENVMAP_BLENDING_MULTIPLY";break;case t0:e="ENVMAP_BLENDING_MIX";break;case n0:e="ENVMAP_BLENDING_ADD";break}return e}function GE(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function WE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=BE(t),c=zE(t),h=HE(t),u=VE(t),d=GE(t),f=IE(t),g=LE(r),v=s.createProgram(),m,p,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(qa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(qa).join(`
`),p.length>0&&(p+=`
`)):(m=[Z0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(qa).join(`
`),p=[Z0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==fs?"#define TONE_MAPPING":"",t.toneMapping!==fs?ht.tonemapping_pars_fragment:"",t.toneMapping!==fs?CE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,RE("linearToOutputTexel",t.outputColorSpace),PE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(qa).join(`
`)),o=Wf(o),o=X0(o,t),o=q0(o,t),a=Wf(a),a=X0(a,t),a=q0(a,t),o=Y0(o),a=Y0(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===Af?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Af?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let b=M+m+o,_=M+p+a,I=G0(s,s.VERTEX_SHADER,b),R=G0(s,s.FRAGMENT_SHADER,_);s.attachShader(v,I),s.attachShader(v,R),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(i.debug.checkShaderErrors){let B=s.getProgramInfoLog(v)||"",V=s.getShaderInfoLog(I)||"",$=s.getShaderInfoLog(R)||"",X=B.trim(),q=V.trim(),Q=$.trim(),Z=!0,ae=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(Z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,I,R);else{let le=$0(s,I,"vertex"),_e=$0(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+X+`
`+le+`
`+_e)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(q===""||Q==="")&&(ae=!1);ae&&(C.diagnostics={runnable:Z,programLog:X,vertexShader:{log:q,prefix:m},fragmentShader:{log:Q,prefix:p}})}s.deleteShader(I),s.deleteShader(R),N=new Co(s,v),T=kE(s,v)}let N;this.getUniforms=function(){return N===void 0&&D(this),N};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,SE)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=TE++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=I,this.fragmentShader=R,this}var $E=0,$f=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Xf(e),t.set(e,n)),n}},Xf=class{constructor(e){this.id=$E++,this.code=e,this.usedTimes=0}};function XE(i,e,t,n,s,r,o){let a=new go,l=new $f,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures,f=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,S,C,B,V){let $=B.fog,X=V.geometry,q=T.isMeshStandardMaterial?B.environment:null,Q=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),Z=Q&&Q.mapping===za?Q.image.height:null,ae=g[T.type];T.precision!==null&&(f=s.getMaxPrecision(T.precision),f!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",f,"instead."));let le=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,_e=le!==void 0?le.length:0,Me=0;X.morphAttributes.position!==void 0&&(Me=1),X.morphAttributes.normal!==void 0&&(Me=2),X.morphAttributes.color!==void 0&&(Me=3);let ve,rt,et,ee;if(ae){let vt=qi[ae];ve=vt.vertexShader,rt=vt.fragmentShader}else ve=T.vertexShader,rt=T.fragmentShader,l.update(T),et=l.getVertexShaderID(T),ee=l.getFragmentShaderID(T);let ne=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),Ve=V.isInstancedMesh===!0,xe=V.isBatchedMesh===!0,nt=!!T.map,Ut=!!T.matcap,F=!!Q,gt=!!T.aoMap,je=!!T.lightMap,Xe=!!T.bumpMap,Ue=!!T.normalMap,At=!!T.displacementMap,Ie=!!T.emissiveMap,$e=!!T.metalnessMap,Gt=!!T.roughnessMap,wt=T.anisotropy>0,L=T.clearcoat>0,x=T.dispersion>0,U=T.iridescence>0,j=T.sheen>0,ie=T.transmission>0,te=wt&&!!T.anisotropyMap,Oe=L&&!!T.clearcoatMap,de=L&&!!T.clearcoatNormalMap,De=L&&!!T.clearcoatRoughnessMap,Ce=U&&!!T.iridescenceMap,oe=U&&!!T.iridescenceThicknessMap,ye=j&&!!T.sheenColorMap,He=j&&!!T.sheenRoughnessMap,ze=!!T.specularMap,be=!!T.specularColorMap,Qe=!!T.specularIntensityMap,z=ie&&!!T.transmissionMap,fe=ie&&!!T.thicknessMap,me=!!T.gradientMap,Le=!!T.alphaMap,ue=T.alphaTest>0,re=!!T.alphaHash,Be=!!T.extensions,it=fs;T.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(it=i.toneMapping);let It={shaderID:ae,shaderType:T.type,shaderName:T.name,vertexShader:ve,fragmentShader:rt,defines:T.defines,customVertexShaderID:et,customFragmentShaderID:ee,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:f,batching:xe,batchingColor:xe&&V._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&V.instanceColor!==null,instancingMorph:Ve&&V.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ne===null?i.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:lr,alphaToCoverage:!!T.alphaToCoverage,map:nt,matcap:Ut,envMap:F,envMapMode:F&&Q.mapping,envMapCubeUVHeight:Z,aoMap:gt,lightMap:je,bumpMap:Xe,normalMap:Ue,displacementMap:d&&At,emissiveMap:Ie,normalMapObjectSpace:Ue&&T.normalMapType===f0,normalMapTangentSpace:Ue&&T.normalMapType===Tf,metalnessMap:$e,roughnessMap:Gt,anisotropy:wt,anisotropyMap:te,clearcoat:L,clearcoatMap:Oe,clearcoatNormalMap:de,clearcoatRoughnessMap:De,dispersion:x,iridescence:U,iridescenceMap:Ce,iridescenceThicknessMap:oe,sheen:j,sheenColorMap:ye,sheenRoughnessMap:He,specularMap:ze,specularColorMap:be,specularIntensityMap:Qe,transmission:ie,transmissionMap:z,thicknessMap:fe,gradientMap:me,opaque:T.transparent===!1&&T.blending===or&&T.alphaToCoverage===!1,alphaMap:Le,alphaTest:ue,alphaHash:re,combine:T.combine,mapUv:nt&&v(T.map.channel),aoMapUv:gt&&v(T.aoMap.channel),lightMapUv:je&&v(T.lightMap.channel),bumpMapUv:Xe&&v(T.bumpMap.channel),normalMapUv:Ue&&v(T.normalMap.channel),displacementMapUv:At&&v(T.displacementMap.channel),emissiveMapUv:Ie&&v(T.emissiveMap.channel),metalnessMapUv:$e&&v(T.metalnessMap.channel),roughnessMapUv:Gt&&v(T.roughnessMap.channel),anisotropyMapUv:te&&v(T.anisotropyMap.channel),clearcoatMapUv:Oe&&v(T.clearcoatMap.channel),clearcoatNormalMapUv:de&&v(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:De&&v(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Ce&&v(T.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&v(T.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&v(T.sheenColorMap.channel),sheenRoughnessMapUv:He&&v(T.sheenRoughnessMap.channel),specularMapUv:ze&&v(T.specularMap.channel),specularColorMapUv:be&&v(T.specularColorMap.channel),specularIntensityMapUv:Qe&&v(T.specularIntensityMap.channel),transmissionMapUv:z&&v(T.transmissionMap.channel),thicknessMapUv:fe&&v(T.thicknessMap.channel),alphaMapUv:Le&&v(T.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(Ue||wt),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!X.attributes.uv&&(nt||Le),fog:!!$,useFog:T.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Ee,skinning:V.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:Me,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:it,decodeVideoTexture:nt&&T.map.isVideoTexture===!0&&yt.getTransfer(T.map.colorSpace)===Pt,decodeVideoTextureEmissive:Ie&&T.emissiveMap.isVideoTexture===!0&&yt.getTransfer(T.emissiveMap.colorSpace)===Pt,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===hi,flipSided:T.side===On,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Be&&T.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Be&&T.extensions.multiDraw===!0||xe)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return It.vertexUv1s=c.has(1),It.vertexUv2s=c.has(2),It.vertexUv3s=c.has(3),c.clear(),It}function p(T){let S=[];if(T.shaderID?S.push(T.shaderID):(S.push(T.customVertexShaderID),S.push(T.customFragmentShaderID)),T.defines!==void 0)for(let C in T.defines)S.push(C),S.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(M(S,T),b(S,T),S.push(i.outputColorSpace)),S.push(T.customProgramCacheKey),S.join()}function M(T,S){T.push(S.precision),T.push(S.outputColorSpace),T.push(S.envMapMode),T.push(S.envMapCubeUVHeight),T.push(S.mapUv),T.push(S.alphaMapUv),T.push(S.lightMapUv),T.push(S.aoMapUv),T.push(S.bumpMapUv),T.push(S.normalMapUv),T.push(S.displacementMapUv),T.push(S.emissiveMapUv),T.push(S.metalnessMapUv),T.push(S.roughnessMapUv),T.push(S.anisotropyMapUv),T.push(S.clearcoatMapUv),T.push(S.clearcoatNormalMapUv),T.push(S.clearcoatRoughnessMapUv),T.push(S.iridescenceMapUv),T.push(S.iridescenceThicknessMapUv),T.push(S.sheenColorMapUv),T.push(S.sheenRoughnessMapUv),T.push(S.specularMapUv),T.push(S.specularColorMapUv),T.push(S.specularIntensityMapUv),T.push(S.transmissionMapUv),T.push(S.thicknessMapUv),T.push(S.combine),T.push(S.fogExp2),T.push(S.sizeAttenuation),T.push(S.morphTargetsCount),T.push(S.morphAttributeCount),T.push(S.numDirLights),T.push(S.numPointLights),T.push(S.numSpotLights),T.push(S.numSpotLightMaps),T.push(S.numHemiLights),T.push(S.numRectAreaLights),T.push(S.numDirLightShadows),T.push(S.numPointLightShadows),T.push(S.numSpotLightShadows),T.push(S.numSpotLightShadowsWithMaps),T.push(S.numLightProbes),T.push(S.shadowMapType),T.push(S.toneMapping),T.push(S.numClippingPlanes),T.push(S.numClipIntersection),T.push(S.depthPacking)}function b(T,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),T.push(a.mask)}function _(T){let S=g[T.type],C;if(S){let B=qi[S];C=S0.clone(B.uniforms)}else C=T.uniforms;return C}function I(T,S){let C;for(let B=0,V=h.length;B<V;B++){let $=h[B];if($.cacheKey===S){C=$,++C.usedTimes;break}}return C===void 0&&(C=new WE(i,S,T,r),h.push(C)),C}function R(T){if(--T.usedTimes===0){let S=h.indexOf(T);h[S]=h[h.length-1],h.pop(),T.destroy()}}function D(T){l.remove(T)}function N(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:_,acquireProgram:I,releaseProgram:R,releaseShaderCache:D,programs:h,dispose:N}}function qE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function YE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function K0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function j0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u,d,f,g,v,m){let p=i[e];return p===void 0?(p={id:u.id,object:u,geometry:d,material:f,groupOrder:g,renderOrder:u.renderOrder,z:v,group:m},i[e]=p):(p.id=u.id,p.object=u,p.geometry=d,p.material=f,p.groupOrder=g,p.renderOrder=u.renderOrder,p.z=v,p.group=m),e++,p}function a(u,d,f,g,v,m){let p=o(u,d,f,g,v,m);f.transmission>0?n.push(p):f.transparent===!0?s.push(p):t.push(p)}function l(u,d,f,g,v,m){let p=o(u,d,f,g,v,m);f.transmission>0?n.unshift(p):f.transparent===!0?s.unshift(p):t.unshift(p)}function c(u,d){t.length>1&&t.sort(u||YE),n.length>1&&n.sort(d||K0),s.length>1&&s.sort(d||K0)}function h(){for(let u=e,d=i.length;u<d;u++){let f=i[u];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function ZE(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new j0,i.set(n,[o])):s>=r.length?(o=new j0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function KE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new O,color:new Ke};break;case"SpotLight":t={position:new O,direction:new O,color:new Ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new O,color:new Ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new O,skyColor:new Ke,groundColor:new Ke};break;case"RectAreaLight":t={color:new Ke,position:new O,halfWidth:new O,halfHeight:new O};break}return i[e.id]=t,t}}}function jE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var JE=0;function QE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function e1(i){let e=new KE,t=jE(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new O);let s=new O,r=new Tt,o=new Tt;function a(c){let h=0,u=0,d=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let f=0,g=0,v=0,m=0,p=0,M=0,b=0,_=0,I=0,R=0,D=0;c.sort(QE);for(let T=0,S=c.length;T<S;T++){let C=c[T],B=C.color,V=C.intensity,$=C.distance,X=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=B.r*V,u+=B.g*V,d+=B.b*V;else if(C.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(C.sh.coefficients[q],V);D++}else if(C.isDirectionalLight){let q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let Q=C.shadow,Z=t.get(C);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,n.directionalShadow[f]=Z,n.directionalShadowMap[f]=X,n.directionalShadowMatrix[f]=C.shadow.matrix,M++}n.directional[f]=q,f++}else if(C.isSpotLight){let q=e.get(C);q.position.setFromMatrixPosition(C.matrixWorld),q.color.copy(B).multiplyScalar(V),q.distance=$,q.coneCos=Math.cos(C.angle),q.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),q.decay=C.decay,n.spot[v]=q;let Q=C.shadow;if(C.map&&(n.spotLightMap[I]=C.map,I++,Q.updateMatrices(C),C.castShadow&&R++),n.spotLightMatrix[v]=Q.matrix,C.castShadow){let Z=t.get(C);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,n.spotShadow[v]=Z,n.spotShadowMap[v]=X,_++}v++}else if(C.isRectAreaLight){let q=e.get(C);q.color.copy(B).multiplyScalar(V),q.halfWidth.set(C.width*.5,0,0),q.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=q,m++}else if(C.isPointLight){let q=e.get(C);if(q.color.copy(C.color).multiplyScalar(C.intensity),q.distance=C.distance,q.decay=C.decay,C.castShadow){let Q=C.shadow,Z=t.get(C);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,Z.shadowCameraNear=Q.camera.near,Z.shadowCameraFar=Q.camera.far,n.pointShadow[g]=Z,n.pointShadowMap[g]=X,n.pointShadowMatrix[g]=C.shadow.matrix,b++}n.point[g]=q,g++}else if(C.isHemisphereLight){let q=e.get(C);q.skyColor.copy(C.color).multiplyScalar(V),q.groundColor.copy(C.groundColor).multiplyScalar(V),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Te.LTC_FLOAT_1,n.rectAreaLTC2=Te.LTC_FLOAT_2):(n.rectAreaLTC1=Te.LTC_HALF_1,n.rectAreaLTC2=Te.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let N=n.hash;(N.directionalLength!==f||N.pointLength!==g||N.spotLength!==v||N.rectAreaLength!==m||N.hemiLength!==p||N.numDirectionalShadows!==M||N.numPointShadows!==b||N.numSpotShadows!==_||N.numSpotMaps!==I||N.numLightProbes!==D)&&(n.directional.length=f,n.spot.length=v,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=b,n.pointShadowMap.length=b,n.spotShadow.length=_,n.spotShadowMap.length=_,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=b,n.spotLightMatrix.length=_+I-R,n.spotLightMap.length=I,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=D,N.directionalLength=f,N.pointLength=g,N.spotLength=v,N.rectAreaLength=m,N.hemiLength=p,N.numDirectionalShadows=M,N.numPointShadows=b,N.numSpotShadows=_,N.numSpotMaps=I,N.numLightProbes=D,n.version=JE++)}function l(c,h){let u=0,d=0,f=0,g=0,v=0,m=h.matrixWorldInverse;for(let p=0,M=c.length;p<M;p++){let b=c[p];if(b.isDirectionalLight){let _=n.directional[u];_.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(m),u++}else if(b.isSpotLight){let _=n.spot[f];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(m),_.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),_.direction.sub(s),_.direction.transformDirection(m),f++}else if(b.isRectAreaLight){let _=n.rectArea[g];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),_.halfWidth.set(b.width*.5,0,0),_.halfHeight.set(0,b.height*.5,0),_.halfWidth.applyMatrix4(o),_.halfHeight.applyMatrix4(o),g++}else if(b.isPointLight){let _=n.point[d];_.position.setFromMatrixPosition(b.matrixWorld),_.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let _=n.hemi[v];_.direction.setFromMatrixPosition(b.matrixWorld),_.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:n}}function J0(i){let e=new e1(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function r(h){t.push(h)}function o(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function t1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new J0(i),e.set(s,[a])):r>=o.length?(a=new J0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var n1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,i1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function s1(i,e,t){let n=new vo,s=new we,r=new we,o=new jt,a=new Ec({depthPacking:d0}),l=new Ac,c={},h=t.maxTextureSize,u={[ls]:On,[On]:ls,[hi]:hi},d=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new we},radius:{value:4}},vertexShader:n1,fragmentShader:i1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Vt;g.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new ft(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=df;let p=this.type;this.render=function(R,D,N){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;let T=i.getRenderTarget(),S=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ds),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=p!==$i&&this.type===$i,$=p===$i&&this.type!==$i;for(let X=0,q=R.length;X<q;X++){let Q=R[X],Z=Q.shadow;if(Z===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(Z.autoUpdate===!1&&Z.needsUpdate===!1)continue;s.copy(Z.mapSize);let ae=Z.getFrameExtents();if(s.multiply(ae),r.copy(Z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ae.x),s.x=r.x*ae.x,Z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ae.y),s.y=r.y*ae.y,Z.mapSize.y=r.y)),Z.map===null||V===!0||$===!0){let _e=this.type!==$i?{minFilter:ci,magFilter:ci}:{};Z.map!==null&&Z.map.dispose(),Z.map=new zi(s.x,s.y,_e),Z.map.texture.name=Q.name+".shadowMap",Z.camera.updateProjectionMatrix()}i.setRenderTarget(Z.map),i.clear();let le=Z.getViewportCount();for(let _e=0;_e<le;_e++){let Me=Z.getViewport(_e);o.set(r.x*Me.x,r.y*Me.y,r.x*Me.z,r.y*Me.w),B.viewport(o),Z.updateMatrices(Q,_e),n=Z.getFrustum(),_(D,N,Z.camera,Q,this.type)}Z.isPointLightShadow!==!0&&this.type===$i&&M(Z,N),Z.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(T,S,C)};function M(R,D){let N=e.update(v);d.defines.VSM_SAMPLES!==R.blurSamples&&(d.defines.VSM_SAMPLES=R.blurSamples,f.defines.VSM_SAMPLES=R.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new zi(s.x,s.y)),d.uniforms.shadow_pass.value=R.map.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(D,null,N,d,v,null),f.uniforms.shadow_pass.value=R.mapPass.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(D,null,N,f,v,null)}function b(R,D,N,T){let S=null,C=N.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)S=C;else if(S=N.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let B=S.uuid,V=D.uuid,$=c[B];$===void 0&&($={},c[B]=$);let X=$[V];X===void 0&&(X=S.clone(),$[V]=X,D.addEventListener("dispose",I)),S=X}if(S.visible=D.visible,S.wireframe=D.wireframe,T===$i?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,N.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let B=i.properties.get(S);B.light=N}return S}function _(R,D,N,T,S){if(R.visible===!1)return;if(R.layers.test(D.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&S===$i)&&(!R.frustumCulled||n.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(N.matrixWorldInverse,R.matrixWorld);let V=e.update(R),$=R.material;if(Array.isArray($)){let X=V.groups;for(let q=0,Q=X.length;q<Q;q++){let Z=X[q],ae=$[Z.materialIndex];if(ae&&ae.visible){let le=b(R,ae,T,S);R.onBeforeShadow(i,R,D,N,V,le,Z),i.renderBufferDirect(N,null,V,le,R,Z),R.onAfterShadow(i,R,D,N,V,le,Z)}}}else if($.visible){let X=b(R,$,T,S);R.onBeforeShadow(i,R,D,N,V,X,null),i.renderBufferDirect(N,null,V,X,R,null),R.onAfterShadow(i,R,D,N,V,X,null)}}let B=R.children;for(let V=0,$=B.length;V<$;V++)_(B[V],D,N,T,S)}function I(R){R.target.removeEventListener("dispose",I);for(let N in c){let T=c[N],S=R.target.uuid;S in T&&(T[S].dispose(),delete T[S])}}}var r1={[Oc]:Bc,[zc]:Gc,[Hc]:Wc,[ar]:Vc,[Bc]:Oc,[Gc]:zc,[Wc]:Hc,[Vc]:ar};function o1(i,e){function t(){let z=!1,fe=new jt,me=null,Le=new jt(0,0,0,0);return{setMask:function(ue){me!==ue&&!z&&(i.colorMask(ue,ue,ue,ue),me=ue)},setLocked:function(ue){z=ue},setClear:function(ue,re,Be,it,It){It===!0&&(ue*=it,re*=it,Be*=it),fe.set(ue,re,Be,it),Le.equals(fe)===!1&&(i.clearColor(ue,re,Be,it),Le.copy(fe))},reset:function(){z=!1,me=null,Le.set(-1,0,0,0)}}}function n(){let z=!1,fe=!1,me=null,Le=null,ue=null;return{setReversed:function(re){if(fe!==re){let Be=e.get("EXT_clip_control");re?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),fe=re;let it=ue;ue=null,this.setClear(it)}},getReversed:function(){return fe},setTest:function(re){re?ne(i.DEPTH_TEST):Ee(i.DEPTH_TEST)},setMask:function(re){me!==re&&!z&&(i.depthMask(re),me=re)},setFunc:function(re){if(fe&&(re=r1[re]),Le!==re){switch(re){case Oc:i.depthFunc(i.NEVER);break;case Bc:i.depthFunc(i.ALWAYS);break;case zc:i.depthFunc(i.LESS);break;case ar:i.depthFunc(i.LEQUAL);break;case Hc:i.depthFunc(i.EQUAL);break;case Vc:i.depthFunc(i.GEQUAL);break;case Gc:i.depthFunc(i.GREATER);break;case Wc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Le=re}},setLocked:function(re){z=re},setClear:function(re){ue!==re&&(fe&&(re=1-re),i.clearDepth(re),ue=re)},reset:function(){z=!1,me=null,Le=null,ue=null,fe=!1}}}function s(){let z=!1,fe=null,me=null,Le=null,ue=null,re=null,Be=null,it=null,It=null;return{setTest:function(vt){z||(vt?ne(i.STENCIL_TEST):Ee(i.STENCIL_TEST))},setMask:function(vt){fe!==vt&&!z&&(i.stencilMask(vt),fe=vt)},setFunc:function(vt,bn,Dt){(me!==vt||Le!==bn||ue!==Dt)&&(i.stencilFunc(vt,bn,Dt),me=vt,Le=bn,ue=Dt)},setOp:function(vt,bn,Dt){(re!==vt||Be!==bn||it!==Dt)&&(i.stencilOp(vt,bn,Dt),re=vt,Be=bn,it=Dt)},setLocked:function(vt){z=vt},setClear:function(vt){It!==vt&&(i.clearStencil(vt),It=vt)},reset:function(){z=!1,fe=null,me=null,Le=null,ue=null,re=null,Be=null,it=null,It=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},u={},d=new WeakMap,f=[],g=null,v=!1,m=null,p=null,M=null,b=null,_=null,I=null,R=null,D=new Ke(0,0,0),N=0,T=!1,S=null,C=null,B=null,V=null,$=null,X=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,Q=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Z)[1]),q=Q>=1):Z.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),q=Q>=2);let ae=null,le={},_e=i.getParameter(i.SCISSOR_BOX),Me=i.getParameter(i.VIEWPORT),ve=new jt().fromArray(_e),rt=new jt().fromArray(Me);function et(z,fe,me,Le){let ue=new Uint8Array(4),re=i.createTexture();i.bindTexture(z,re),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Be=0;Be<me;Be++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(fe,0,i.RGBA,1,1,Le,0,i.RGBA,i.UNSIGNED_BYTE,ue):i.texImage2D(fe+Be,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ue);return re}let ee={};ee[i.TEXTURE_2D]=et(i.TEXTURE_2D,i.TEXTURE_2D,1),ee[i.TEXTURE_CUBE_MAP]=et(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[i.TEXTURE_2D_ARRAY]=et(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ee[i.TEXTURE_3D]=et(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(i.DEPTH_TEST),o.setFunc(ar),Xe(!1),Ue(uf),ne(i.CULL_FACE),gt(ds);function ne(z){h[z]!==!0&&(i.enable(z),h[z]=!0)}function Ee(z){h[z]!==!1&&(i.disable(z),h[z]=!1)}function Ve(z,fe){return u[z]!==fe?(i.bindFramebuffer(z,fe),u[z]=fe,z===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=fe),z===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=fe),!0):!1}function xe(z,fe){let me=f,Le=!1;if(z){me=d.get(fe),me===void 0&&(me=[],d.set(fe,me));let ue=z.textures;if(me.length!==ue.length||me[0]!==i.COLOR_ATTACHMENT0){for(let re=0,Be=ue.length;re<Be;re++)me[re]=i.COLOR_ATTACHMENT0+re;me.length=ue.length,Le=!0}}else me[0]!==i.BACK&&(me[0]=i.BACK,Le=!0);Le&&i.drawBuffers(me)}function nt(z){return g!==z?(i.useProgram(z),g=z,!0):!1}let Ut={[ks]:i.FUNC_ADD,[Og]:i.FUNC_SUBTRACT,[Bg]:i.FUNC_REVERSE_SUBTRACT};Ut[zg]=i.MIN,Ut[Hg]=i.MAX;let F={[Vg]:i.ZERO,[Gg]:i.ONE,[Wg]:i.SRC_COLOR,[co]:i.SRC_ALPHA,[Kg]:i.SRC_ALPHA_SATURATE,[Yg]:i.DST_COLOR,[Xg]:i.DST_ALPHA,[$g]:i.ONE_MINUS_SRC_COLOR,[ho]:i.ONE_MINUS_SRC_ALPHA,[Zg]:i.ONE_MINUS_DST_COLOR,[qg]:i.ONE_MINUS_DST_ALPHA,[jg]:i.CONSTANT_COLOR,[Jg]:i.ONE_MINUS_CONSTANT_COLOR,[Qg]:i.CONSTANT_ALPHA,[e0]:i.ONE_MINUS_CONSTANT_ALPHA};function gt(z,fe,me,Le,ue,re,Be,it,It,vt){if(z===ds){v===!0&&(Ee(i.BLEND),v=!1);return}if(v===!1&&(ne(i.BLEND),v=!0),z!==Uc){if(z!==m||vt!==T){if((p!==ks||_!==ks)&&(i.blendEquation(i.FUNC_ADD),p=ks,_=ks),vt)switch(z){case or:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ff:i.blendFunc(i.ONE,i.ONE);break;case pf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case mf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}else switch(z){case or:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case ff:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case pf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case mf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}M=null,b=null,I=null,R=null,D.set(0,0,0),N=0,m=z,T=vt}return}ue=ue||fe,re=re||me,Be=Be||Le,(fe!==p||ue!==_)&&(i.blendEquationSeparate(Ut[fe],Ut[ue]),p=fe,_=ue),(me!==M||Le!==b||re!==I||Be!==R)&&(i.blendFuncSeparate(F[me],F[Le],F[re],F[Be]),M=me,b=Le,I=re,R=Be),(it.equals(D)===!1||It!==N)&&(i.blendColor(it.r,it.g,it.b,It),D.copy(it),N=It),m=z,T=!1}function je(z,fe){z.side===hi?Ee(i.CULL_FACE):ne(i.CULL_FACE);let me=z.side===On;fe&&(me=!me),Xe(me),z.blending===or&&z.transparent===!1?gt(ds):gt(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Le=z.stencilWrite;a.setTest(Le),Le&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),Ie(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?ne(i.SAMPLE_ALPHA_TO_COVERAGE):Ee(i.SAMPLE_ALPHA_TO_COVERAGE)}function Xe(z){S!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),S=z)}function Ue(z){z!==Ng?(ne(i.CULL_FACE),z!==C&&(z===uf?i.cullFace(i.BACK):z===Fg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ee(i.CULL_FACE),C=z}function At(z){z!==B&&(q&&i.lineWidth(z),B=z)}function Ie(z,fe,me){z?(ne(i.POLYGON_OFFSET_FILL),(V!==fe||$!==me)&&(i.polygonOffset(fe,me),V=fe,$=me)):Ee(i.POLYGON_OFFSET_FILL)}function $e(z){z?ne(i.SCISSOR_TEST):Ee(i.SCISSOR_TEST)}function Gt(z){z===void 0&&(z=i.TEXTURE0+X-1),ae!==z&&(i.activeTexture(z),ae=z)}function wt(z,fe,me){me===void 0&&(ae===null?me=i.TEXTURE0+X-1:me=ae);let Le=le[me];Le===void 0&&(Le={type:void 0,texture:void 0},le[me]=Le),(Le.type!==z||Le.texture!==fe)&&(ae!==me&&(i.activeTexture(me),ae=me),i.bindTexture(z,fe||ee[z]),Le.type=z,Le.texture=fe)}function L(){let z=le[ae];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function U(){try{i.compressedTexImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function j(){try{i.texSubImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ie(){try{i.texSubImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function te(){try{i.compressedTexSubImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Oe(){try{i.compressedTexSubImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function de(){try{i.texStorage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function De(){try{i.texStorage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Ce(){try{i.texImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function oe(){try{i.texImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ye(z){ve.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),ve.copy(z))}function He(z){rt.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),rt.copy(z))}function ze(z,fe){let me=c.get(fe);me===void 0&&(me=new WeakMap,c.set(fe,me));let Le=me.get(z);Le===void 0&&(Le=i.getUniformBlockIndex(fe,z.name),me.set(z,Le))}function be(z,fe){let Le=c.get(fe).get(z);l.get(fe)!==Le&&(i.uniformBlockBinding(fe,Le,z.__bindingPointIndex),l.set(fe,Le))}function Qe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ae=null,le={},u={},d=new WeakMap,f=[],g=null,v=!1,m=null,p=null,M=null,b=null,_=null,I=null,R=null,D=new Ke(0,0,0),N=0,T=!1,S=null,C=null,B=null,V=null,$=null,ve.set(0,0,i.canvas.width,i.canvas.height),rt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:Ee,bindFramebuffer:Ve,drawBuffers:xe,useProgram:nt,setBlending:gt,setMaterial:je,setFlipSided:Xe,setCullFace:Ue,setLineWidth:At,setPolygonOffset:Ie,setScissorTest:$e,activeTexture:Gt,bindTexture:wt,unbindTexture:L,compressedTexImage2D:x,compressedTexImage3D:U,texImage2D:Ce,texImage3D:oe,updateUBOMapping:ze,uniformBlockBinding:be,texStorage2D:de,texStorage3D:De,texSubImage2D:j,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Oe,scissor:ye,viewport:He,reset:Qe}}function a1(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new we,h=new WeakMap,u,d=new WeakMap,f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,x){return f?new OffscreenCanvas(L,x):fa("canvas")}function v(L,x,U){let j=1,ie=wt(L);if((ie.width>U||ie.height>U)&&(j=U/Math.max(ie.width,ie.height)),j<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let te=Math.floor(j*ie.width),Oe=Math.floor(j*ie.height);u===void 0&&(u=g(te,Oe));let de=x?g(te,Oe):u;return de.width=te,de.height=Oe,de.getContext("2d").drawImage(L,0,0,te,Oe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Oe+")."),de}else return"data"in L&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),L;return L}function m(L){return L.generateMipmaps}function p(L){i.generateMipmap(L)}function M(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function b(L,x,U,j,ie=!1){if(L!==null){if(i[L]!==void 0)return i[L];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let te=x;if(x===i.RED&&(U===i.FLOAT&&(te=i.R32F),U===i.HALF_FLOAT&&(te=i.R16F),U===i.UNSIGNED_BYTE&&(te=i.R8)),x===i.RED_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.R8UI),U===i.UNSIGNED_SHORT&&(te=i.R16UI),U===i.UNSIGNED_INT&&(te=i.R32UI),U===i.BYTE&&(te=i.R8I),U===i.SHORT&&(te=i.R16I),U===i.INT&&(te=i.R32I)),x===i.RG&&(U===i.FLOAT&&(te=i.RG32F),U===i.HALF_FLOAT&&(te=i.RG16F),U===i.UNSIGNED_BYTE&&(te=i.RG8)),x===i.RG_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RG8UI),U===i.UNSIGNED_SHORT&&(te=i.RG16UI),U===i.UNSIGNED_INT&&(te=i.RG32UI),U===i.BYTE&&(te=i.RG8I),U===i.SHORT&&(te=i.RG16I),U===i.INT&&(te=i.RG32I)),x===i.RGB_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RGB8UI),U===i.UNSIGNED_SHORT&&(te=i.RGB16UI),U===i.UNSIGNED_INT&&(te=i.RGB32UI),U===i.BYTE&&(te=i.RGB8I),U===i.SHORT&&(te=i.RGB16I),U===i.INT&&(te=i.RGB32I)),x===i.RGBA_INTEGER&&(U===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),U===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),U===i.UNSIGNED_INT&&(te=i.RGBA32UI),U===i.BYTE&&(te=i.RGBA8I),U===i.SHORT&&(te=i.RGBA16I),U===i.INT&&(te=i.RGBA32I)),x===i.RGB&&(U===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),U===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),x===i.RGBA){let Oe=ie?ua:yt.getTransfer(j);U===i.FLOAT&&(te=i.RGBA32F),U===i.HALF_FLOAT&&(te=i.RGBA16F),U===i.UNSIGNED_BYTE&&(te=Oe===Pt?i.SRGB8_ALPHA8:i.RGBA8),U===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),U===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(L,x){let U;return L?x===null||x===zs||x===To?U=i.DEPTH24_STENCIL8:x===Xi?U=i.DEPTH32F_STENCIL8:x===Mo&&(U=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===zs||x===To?U=i.DEPTH_COMPONENT24:x===Xi?U=i.DEPTH_COMPONENT32F:x===Mo&&(U=i.DEPTH_COMPONENT16),U}function I(L,x){return m(L)===!0||L.isFramebufferTexture&&L.minFilter!==ci&&L.minFilter!==Si?Math.log2(Math.max(x.width,x.height))+1:L.mipmaps!==void 0&&L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?x.mipmaps.length:1}function R(L){let x=L.target;x.removeEventListener("dispose",R),N(x),x.isVideoTexture&&h.delete(x)}function D(L){let x=L.target;x.removeEventListener("dispose",D),S(x)}function N(L){let x=n.get(L);if(x.__webglInit===void 0)return;let U=L.source,j=d.get(U);if(j){let ie=j[x.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&T(L),Object.keys(j).length===0&&d.delete(U)}n.remove(L)}function T(L){let x=n.get(L);i.deleteTexture(x.__webglTexture);let U=L.source,j=d.get(U);delete j[x.__cacheKey],o.memory.textures--}function S(L){let x=n.get(L);if(L.depthTexture&&(L.depthTexture.dispose(),n.remove(L.depthTexture)),L.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(x.__webglFramebuffer[j]))for(let ie=0;ie<x.__webglFramebuffer[j].length;ie++)i.deleteFramebuffer(x.__webglFramebuffer[j][ie]);else i.deleteFramebuffer(x.__webglFramebuffer[j]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[j])}else{if(Array.isArray(x.__webglFramebuffer))for(let j=0;j<x.__webglFramebuffer.length;j++)i.deleteFramebuffer(x.__webglFramebuffer[j]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let j=0;j<x.__webglColorRenderbuffer.length;j++)x.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[j]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let U=L.textures;for(let j=0,ie=U.length;j<ie;j++){let te=n.get(U[j]);te.__webglTexture&&(i.deleteTexture(te.__webglTexture),o.memory.textures--),n.remove(U[j])}n.remove(L)}let C=0;function B(){C=0}function V(){let L=C;return L>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+L+" texture units while this GPU supports only "+s.maxTextures),C+=1,L}function $(L){let x=[];return x.push(L.wrapS),x.push(L.wrapT),x.push(L.wrapR||0),x.push(L.magFilter),x.push(L.minFilter),x.push(L.anisotropy),x.push(L.internalFormat),x.push(L.format),x.push(L.type),x.push(L.generateMipmaps),x.push(L.premultiplyAlpha),x.push(L.flipY),x.push(L.unpackAlignment),x.push(L.colorSpace),x.join()}function X(L,x){let U=n.get(L);if(L.isVideoTexture&&$e(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&U.__version!==L.version){let j=L.image;if(j===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(j.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(U,L,x);return}}else L.isExternalTexture&&(U.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,U.__webglTexture,i.TEXTURE0+x)}function q(L,x){let U=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&U.__version!==L.version){ee(U,L,x);return}t.bindTexture(i.TEXTURE_2D_ARRAY,U.__webglTexture,i.TEXTURE0+x)}function Q(L,x){let U=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&U.__version!==L.version){ee(U,L,x);return}t.bindTexture(i.TEXTURE_3D,U.__webglTexture,i.TEXTURE0+x)}function Z(L,x){let U=n.get(L);if(L.version>0&&U.__version!==L.version){ne(U,L,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,U.__webglTexture,i.TEXTURE0+x)}let ae={[hc]:i.REPEAT,[Ls]:i.CLAMP_TO_EDGE,[uc]:i.MIRRORED_REPEAT},le={[ci]:i.NEAREST,[h0]:i.NEAREST_MIPMAP_NEAREST,[Ha]:i.NEAREST_MIPMAP_LINEAR,[Si]:i.LINEAR,[Yc]:i.LINEAR_MIPMAP_NEAREST,[Bs]:i.LINEAR_MIPMAP_LINEAR},_e={[p0]:i.NEVER,[x0]:i.ALWAYS,[m0]:i.LESS,[Ef]:i.LEQUAL,[g0]:i.EQUAL,[_0]:i.GEQUAL,[y0]:i.GREATER,[v0]:i.NOTEQUAL};function Me(L,x){if(x.type===Xi&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===Si||x.magFilter===Yc||x.magFilter===Ha||x.magFilter===Bs||x.minFilter===Si||x.minFilter===Yc||x.minFilter===Ha||x.minFilter===Bs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,ae[x.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,ae[x.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,ae[x.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,le[x.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,le[x.minFilter]),x.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,_e[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===ci||x.minFilter!==Ha&&x.minFilter!==Bs||x.type===Xi&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let U=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function ve(L,x){let U=!1;L.__webglInit===void 0&&(L.__webglInit=!0,x.addEventListener("dispose",R));let j=x.source,ie=d.get(j);ie===void 0&&(ie={},d.set(j,ie));let te=$(x);if(te!==L.__cacheKey){ie[te]===void 0&&(ie[te]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,U=!0),ie[te].usedTimes++;let Oe=ie[L.__cacheKey];Oe!==void 0&&(ie[L.__cacheKey].usedTimes--,Oe.usedTimes===0&&T(x)),L.__cacheKey=te,L.__webglTexture=ie[te].texture}return U}function rt(L,x,U){return Math.floor(Math.floor(L/U)/x)}function et(L,x,U,j){let te=L.updateRanges;if(te.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,U,j,x.data);else{te.sort((oe,ye)=>oe.start-ye.start);let Oe=0;for(let oe=1;oe<te.length;oe++){let ye=te[Oe],He=te[oe],ze=ye.start+ye.count,be=rt(He.start,x.width,4),Qe=rt(ye.start,x.width,4);He.start<=ze+1&&be===Qe&&rt(He.start+He.count-1,x.width,4)===be?ye.count=Math.max(ye.count,He.start+He.count-ye.start):(++Oe,te[Oe]=He)}te.length=Oe+1;let de=i.getParameter(i.UNPACK_ROW_LENGTH),De=i.getParameter(i.UNPACK_SKIP_PIXELS),Ce=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let oe=0,ye=te.length;oe<ye;oe++){let He=te[oe],ze=Math.floor(He.start/4),be=Math.ceil(He.count/4),Qe=ze%x.width,z=Math.floor(ze/x.width),fe=be,me=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Qe),i.pixelStorei(i.UNPACK_SKIP_ROWS,z),t.texSubImage2D(i.TEXTURE_2D,0,Qe,z,fe,me,U,j,x.data)}L.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,de),i.pixelStorei(i.UNPACK_SKIP_PIXELS,De),i.pixelStorei(i.UNPACK_SKIP_ROWS,Ce)}}function ee(L,x,U){let j=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(j=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(j=i.TEXTURE_3D);let ie=ve(L,x),te=x.source;t.bindTexture(j,L.__webglTexture,i.TEXTURE0+U);let Oe=n.get(te);if(te.version!==Oe.__version||ie===!0){t.activeTexture(i.TEXTURE0+U);let de=yt.getPrimaries(yt.workingColorSpace),De=x.colorSpace===ps?null:yt.getPrimaries(x.colorSpace),Ce=x.colorSpace===ps||de===De?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ce);let oe=v(x.image,!1,s.maxTextureSize);oe=Gt(x,oe);let ye=r.convert(x.format,x.colorSpace),He=r.convert(x.type),ze=b(x.internalFormat,ye,He,x.colorSpace,x.isVideoTexture);Me(j,x);let be,Qe=x.mipmaps,z=x.isVideoTexture!==!0,fe=Oe.__version===void 0||ie===!0,me=te.dataReady,Le=I(x,oe);if(x.isDepthTexture)ze=_(x.format===Eo,x.type),fe&&(z?t.texStorage2D(i.TEXTURE_2D,1,ze,oe.width,oe.height):t.texImage2D(i.TEXTURE_2D,0,ze,oe.width,oe.height,0,ye,He,null));else if(x.isDataTexture)if(Qe.length>0){z&&fe&&t.texStorage2D(i.TEXTURE_2D,Le,ze,Qe[0].width,Qe[0].height);for(let ue=0,re=Qe.length;ue<re;ue++)be=Qe[ue],z?me&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,be.width,be.height,ye,He,be.data):t.texImage2D(i.TEXTURE_2D,ue,ze,be.width,be.height,0,ye,He,be.data);x.generateMipmaps=!1}else z?(fe&&t.texStorage2D(i.TEXTURE_2D,Le,ze,oe.width,oe.height),me&&et(x,oe,ye,He)):t.texImage2D(i.TEXTURE_2D,0,ze,oe.width,oe.height,0,ye,He,oe.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){z&&fe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,ze,Qe[0].width,Qe[0].height,oe.depth);for(let ue=0,re=Qe.length;ue<re;ue++)if(be=Qe[ue],x.format!==ui)if(ye!==null)if(z){if(me)if(x.layerUpdates.size>0){let Be=Df(be.width,be.height,x.format,x.type);for(let it of x.layerUpdates){let It=be.data.subarray(it*Be/be.data.BYTES_PER_ELEMENT,(it+1)*Be/be.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,it,be.width,be.height,1,ye,It)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,be.width,be.height,oe.depth,ye,be.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ue,ze,be.width,be.height,oe.depth,0,be.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else z?me&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,be.width,be.height,oe.depth,ye,He,be.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ue,ze,be.width,be.height,oe.depth,0,ye,He,be.data)}else{z&&fe&&t.texStorage2D(i.TEXTURE_2D,Le,ze,Qe[0].width,Qe[0].height);for(let ue=0,re=Qe.length;ue<re;ue++)be=Qe[ue],x.format!==ui?ye!==null?z?me&&t.compressedTexSubImage2D(i.TEXTURE_2D,ue,0,0,be.width,be.height,ye,be.data):t.compressedTexImage2D(i.TEXTURE_2D,ue,ze,be.width,be.height,0,be.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):z?me&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,be.width,be.height,ye,He,be.data):t.texImage2D(i.TEXTURE_2D,ue,ze,be.width,be.height,0,ye,He,be.data)}else if(x.isDataArrayTexture)if(z){if(fe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Le,ze,oe.width,oe.height,oe.depth),me)if(x.layerUpdates.size>0){let ue=Df(oe.width,oe.height,x.format,x.type);for(let re of x.layerUpdates){let Be=oe.data.subarray(re*ue/oe.data.BYTES_PER_ELEMENT,(re+1)*ue/oe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,re,oe.width,oe.height,1,ye,He,Be)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,oe.width,oe.height,oe.depth,ye,He,oe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ze,oe.width,oe.height,oe.depth,0,ye,He,oe.data);else if(x.isData3DTexture)z?(fe&&t.texStorage3D(i.TEXTURE_3D,Le,ze,oe.width,oe.height,oe.depth),me&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,oe.width,oe.height,oe.depth,ye,He,oe.data)):t.texImage3D(i.TEXTURE_3D,0,ze,oe.width,oe.height,oe.depth,0,ye,He,oe.data);else if(x.isFramebufferTexture){if(fe)if(z)t.texStorage2D(i.TEXTURE_2D,Le,ze,oe.width,oe.height);else{let ue=oe.width,re=oe.height;for(let Be=0;Be<Le;Be++)t.texImage2D(i.TEXTURE_2D,Be,ze,ue,re,0,ye,He,null),ue>>=1,re>>=1}}else if(Qe.length>0){if(z&&fe){let ue=wt(Qe[0]);t.texStorage2D(i.TEXTURE_2D,Le,ze,ue.width,ue.height)}for(let ue=0,re=Qe.length;ue<re;ue++)be=Qe[ue],z?me&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ye,He,be):t.texImage2D(i.TEXTURE_2D,ue,ze,ye,He,be);x.generateMipmaps=!1}else if(z){if(fe){let ue=wt(oe);t.texStorage2D(i.TEXTURE_2D,Le,ze,ue.width,ue.height)}me&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ye,He,oe)}else t.texImage2D(i.TEXTURE_2D,0,ze,ye,He,oe);m(x)&&p(j),Oe.__version=te.version,x.onUpdate&&x.onUpdate(x)}L.__version=x.version}function ne(L,x,U){if(x.image.length!==6)return;let j=ve(L,x),ie=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+U);let te=n.get(ie);if(ie.version!==te.__version||j===!0){t.activeTexture(i.TEXTURE0+U);let Oe=yt.getPrimaries(yt.workingColorSpace),de=x.colorSpace===ps?null:yt.getPrimaries(x.colorSpace),De=x.colorSpace===ps||Oe===de?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,De);let Ce=x.isCompressedTexture||x.image[0].isCompressedTexture,oe=x.image[0]&&x.image[0].isDataTexture,ye=[];for(let re=0;re<6;re++)!Ce&&!oe?ye[re]=v(x.image[re],!0,s.maxCubemapSize):ye[re]=oe?x.image[re].image:x.image[re],ye[re]=Gt(x,ye[re]);let He=ye[0],ze=r.convert(x.format,x.colorSpace),be=r.convert(x.type),Qe=b(x.internalFormat,ze,be,x.colorSpace),z=x.isVideoTexture!==!0,fe=te.__version===void 0||j===!0,me=ie.dataReady,Le=I(x,He);Me(i.TEXTURE_CUBE_MAP,x);let ue;if(Ce){z&&fe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,Qe,He.width,He.height);for(let re=0;re<6;re++){ue=ye[re].mipmaps;for(let Be=0;Be<ue.length;Be++){let it=ue[Be];x.format!==ui?ze!==null?z?me&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,0,0,it.width,it.height,ze,it.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,Qe,it.width,it.height,0,it.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):z?me&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,0,0,it.width,it.height,ze,be,it.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,Qe,it.width,it.height,0,ze,be,it.data)}}}else{if(ue=x.mipmaps,z&&fe){ue.length>0&&Le++;let re=wt(ye[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Le,Qe,re.width,re.height)}for(let re=0;re<6;re++)if(oe){z?me&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ye[re].width,ye[re].height,ze,be,ye[re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Qe,ye[re].width,ye[re].height,0,ze,be,ye[re].data);for(let Be=0;Be<ue.length;Be++){let It=ue[Be].image[re].image;z?me&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,0,0,It.width,It.height,ze,be,It.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,Qe,It.width,It.height,0,ze,be,It.data)}}else{z?me&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ze,be,ye[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Qe,ze,be,ye[re]);for(let Be=0;Be<ue.length;Be++){let it=ue[Be];z?me&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,0,0,ze,be,it.image[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,Qe,ze,be,it.image[re])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),te.__version=ie.version,x.onUpdate&&x.onUpdate(x)}L.__version=x.version}function Ee(L,x,U,j,ie,te){let Oe=r.convert(U.format,U.colorSpace),de=r.convert(U.type),De=b(U.internalFormat,Oe,de,U.colorSpace),Ce=n.get(x),oe=n.get(U);if(oe.__renderTarget=x,!Ce.__hasExternalTextures){let ye=Math.max(1,x.width>>te),He=Math.max(1,x.height>>te);ie===i.TEXTURE_3D||ie===i.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,De,ye,He,x.depth,0,Oe,de,null):t.texImage2D(ie,te,De,ye,He,0,Oe,de,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),Ie(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,j,ie,oe.__webglTexture,0,At(x)):(ie===i.TEXTURE_2D||ie>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,j,ie,oe.__webglTexture,te),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ve(L,x,U){if(i.bindRenderbuffer(i.RENDERBUFFER,L),x.depthBuffer){let j=x.depthTexture,ie=j&&j.isDepthTexture?j.type:null,te=_(x.stencilBuffer,ie),Oe=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=At(x);Ie(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,de,te,x.width,x.height):U?i.renderbufferStorageMultisample(i.RENDERBUFFER,de,te,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,te,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Oe,i.RENDERBUFFER,L)}else{let j=x.textures;for(let ie=0;ie<j.length;ie++){let te=j[ie],Oe=r.convert(te.format,te.colorSpace),de=r.convert(te.type),De=b(te.internalFormat,Oe,de,te.colorSpace),Ce=At(x);U&&Ie(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ce,De,x.width,x.height):Ie(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ce,De,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,De,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(L,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let j=n.get(x.depthTexture);j.__renderTarget=x,(!j.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),X(x.depthTexture,0);let ie=j.__webglTexture,te=At(x);if(x.depthTexture.format===uo)Ie(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0);else if(x.depthTexture.format===Eo)Ie(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function nt(L){let x=n.get(L),U=L.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==L.depthTexture){let j=L.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),j){let ie=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,j.removeEventListener("dispose",ie)};j.addEventListener("dispose",ie),x.__depthDisposeCallback=ie}x.__boundDepthTexture=j}if(L.depthTexture&&!x.__autoAllocateDepthBuffer){if(U)throw new Error("target.depthTexture not supported in Cube render targets");let j=L.texture.mipmaps;j&&j.length>0?xe(x.__webglFramebuffer[0],L):xe(x.__webglFramebuffer,L)}else if(U){x.__webglDepthbuffer=[];for(let j=0;j<6;j++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[j]),x.__webglDepthbuffer[j]===void 0)x.__webglDepthbuffer[j]=i.createRenderbuffer(),Ve(x.__webglDepthbuffer[j],L,!1);else{let ie=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=x.__webglDepthbuffer[j];i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}else{let j=L.texture.mipmaps;if(j&&j.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Ve(x.__webglDepthbuffer,L,!1);else{let ie=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(L,x,U){let j=n.get(L);x!==void 0&&Ee(j.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),U!==void 0&&nt(L)}function F(L){let x=L.texture,U=n.get(L),j=n.get(x);L.addEventListener("dispose",D);let ie=L.textures,te=L.isWebGLCubeRenderTarget===!0,Oe=ie.length>1;if(Oe||(j.__webglTexture===void 0&&(j.__webglTexture=i.createTexture()),j.__version=x.version,o.memory.textures++),te){U.__webglFramebuffer=[];for(let de=0;de<6;de++)if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer[de]=[];for(let De=0;De<x.mipmaps.length;De++)U.__webglFramebuffer[de][De]=i.createFramebuffer()}else U.__webglFramebuffer[de]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer=[];for(let de=0;de<x.mipmaps.length;de++)U.__webglFramebuffer[de]=i.createFramebuffer()}else U.__webglFramebuffer=i.createFramebuffer();if(Oe)for(let de=0,De=ie.length;de<De;de++){let Ce=n.get(ie[de]);Ce.__webglTexture===void 0&&(Ce.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&Ie(L)===!1){U.__webglMultisampledFramebuffer=i.createFramebuffer(),U.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let de=0;de<ie.length;de++){let De=ie[de];U.__webglColorRenderbuffer[de]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,U.__webglColorRenderbuffer[de]);let Ce=r.convert(De.format,De.colorSpace),oe=r.convert(De.type),ye=b(De.internalFormat,Ce,oe,De.colorSpace,L.isXRRenderTarget===!0),He=At(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,He,ye,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,U.__webglColorRenderbuffer[de])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(U.__webglDepthRenderbuffer=i.createRenderbuffer(),Ve(U.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(te){t.bindTexture(i.TEXTURE_CUBE_MAP,j.__webglTexture),Me(i.TEXTURE_CUBE_MAP,x);for(let de=0;de<6;de++)if(x.mipmaps&&x.mipmaps.length>0)for(let De=0;De<x.mipmaps.length;De++)Ee(U.__webglFramebuffer[de][De],L,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+de,De);else Ee(U.__webglFramebuffer[de],L,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+de,0);m(x)&&p(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Oe){for(let de=0,De=ie.length;de<De;de++){let Ce=ie[de],oe=n.get(Ce),ye=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ye=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ye,oe.__webglTexture),Me(ye,Ce),Ee(U.__webglFramebuffer,L,Ce,i.COLOR_ATTACHMENT0+de,ye,0),m(Ce)&&p(ye)}t.unbindTexture()}else{let de=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(de=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(de,j.__webglTexture),Me(de,x),x.mipmaps&&x.mipmaps.length>0)for(let De=0;De<x.mipmaps.length;De++)Ee(U.__webglFramebuffer[De],L,x,i.COLOR_ATTACHMENT0,de,De);else Ee(U.__webglFramebuffer,L,x,i.COLOR_ATTACHMENT0,de,0);m(x)&&p(de),t.unbindTexture()}L.depthBuffer&&nt(L)}function gt(L){let x=L.textures;for(let U=0,j=x.length;U<j;U++){let ie=x[U];if(m(ie)){let te=M(L),Oe=n.get(ie).__webglTexture;t.bindTexture(te,Oe),p(te),t.unbindTexture()}}}let je=[],Xe=[];function Ue(L){if(L.samples>0){if(Ie(L)===!1){let x=L.textures,U=L.width,j=L.height,ie=i.COLOR_BUFFER_BIT,te=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Oe=n.get(L),de=x.length>1;if(de)for(let Ce=0;Ce<x.length;Ce++)t.bindFramebuffer(i.FRAMEBUFFER,Oe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Oe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Oe.__webglMultisampledFramebuffer);let De=L.texture.mipmaps;De&&De.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let Ce=0;Ce<x.length;Ce++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ie|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ie|=i.STENCIL_BUFFER_BIT)),de){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Oe.__webglColorRenderbuffer[Ce]);let oe=n.get(x[Ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,oe,0)}i.blitFramebuffer(0,0,U,j,0,0,U,j,ie,i.NEAREST),l===!0&&(je.length=0,Xe.length=0,je.push(i.COLOR_ATTACHMENT0+Ce),L.depthBuffer&&L.resolveDepthBuffer===!1&&(je.push(te),Xe.push(te),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Xe)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,je))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),de)for(let Ce=0;Ce<x.length;Ce++){t.bindFramebuffer(i.FRAMEBUFFER,Oe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.RENDERBUFFER,Oe.__webglColorRenderbuffer[Ce]);let oe=n.get(x[Ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Oe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ce,i.TEXTURE_2D,oe,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Oe.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.resolveDepthBuffer===!1&&l){let x=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function At(L){return Math.min(s.maxSamples,L.samples)}function Ie(L){let x=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function $e(L){let x=o.render.frame;h.get(L)!==x&&(h.set(L,x),L.update())}function Gt(L,x){let U=L.colorSpace,j=L.format,ie=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||U!==lr&&U!==ps&&(yt.getTransfer(U)===Pt?(j!==ui||ie!==Ri)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",U)),x}function wt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=V,this.resetTextureUnits=B,this.setTexture2D=X,this.setTexture2DArray=q,this.setTexture3D=Q,this.setTextureCube=Z,this.rebindTextures=Ut,this.setupRenderTarget=F,this.updateRenderTargetMipmap=gt,this.updateMultisampleRenderTarget=Ue,this.setupDepthRenderbuffer=nt,this.setupFrameBufferTexture=Ee,this.useMultisampledRTT=Ie}function l1(i,e){function t(n,s=ps){let r,o=yt.getTransfer(s);if(n===Ri)return i.UNSIGNED_BYTE;if(n===Kc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===jc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===_f)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===xf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===yf)return i.BYTE;if(n===vf)return i.SHORT;if(n===Mo)return i.UNSIGNED_SHORT;if(n===Zc)return i.INT;if(n===zs)return i.UNSIGNED_INT;if(n===Xi)return i.FLOAT;if(n===So)return i.HALF_FLOAT;if(n===bf)return i.ALPHA;if(n===wf)return i.RGB;if(n===ui)return i.RGBA;if(n===uo)return i.DEPTH_COMPONENT;if(n===Eo)return i.DEPTH_STENCIL;if(n===Mf)return i.RED;if(n===Jc)return i.RED_INTEGER;if(n===Sf)return i.RG;if(n===Qc)return i.RG_INTEGER;if(n===eh)return i.RGBA_INTEGER;if(n===Va||n===Ga||n===Wa||n===$a)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Va)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Va)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ga)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Wa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===th||n===nh||n===ih||n===sh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===th)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===sh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===rh||n===oh||n===ah)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===rh||n===oh)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===lh||n===ch||n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===yh||n===vh||n===_h||n===xh||n===bh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===yh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===vh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_h)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===xh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===bh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wh||n===Mh||n===Sh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===wh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Mh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Sh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Th||n===Eh||n===Ah||n===Rh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Th)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Eh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ah)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===To?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var c1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,h1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,qf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new wa(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Ti({vertexShader:c1,fragmentShader:h1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ft(new fr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Yf=class extends Bi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,v=typeof XRWebGLBinding<"u",m=new qf,p={},M=t.getContextAttributes(),b=null,_=null,I=[],R=[],D=new we,N=null,T=new xn;T.viewport=new jt;let S=new xn;S.viewport=new jt;let C=[T,S],B=new Fc,V=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ne=I[ee];return ne===void 0&&(ne=new yo,I[ee]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(ee){let ne=I[ee];return ne===void 0&&(ne=new yo,I[ee]=ne),ne.getGripSpace()},this.getHand=function(ee){let ne=I[ee];return ne===void 0&&(ne=new yo,I[ee]=ne),ne.getHandSpace()};function X(ee){let ne=R.indexOf(ee.inputSource);if(ne===-1)return;let Ee=I[ne];Ee!==void 0&&(Ee.update(ee.inputSource,ee.frame,c||o),Ee.dispatchEvent({type:ee.type,data:ee.inputSource}))}function q(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",Q);for(let ee=0;ee<I.length;ee++){let ne=R[ee];ne!==null&&(R[ee]=null,I[ee].disconnect(ne))}V=null,$=null,m.reset();for(let ee in p)delete p[ee];e.setRenderTarget(b),f=null,d=null,u=null,s=null,_=null,et.stop(),n.isPresenting=!1,e.setPixelRatio(N),e.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&v&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(b=e.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",q),s.addEventListener("inputsourceschange",Q),M.xrCompatible!==!0&&await t.makeXRCompatible(),N=e.getPixelRatio(),e.getSize(D),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ee=null,Ve=null,xe=null;M.depth&&(xe=M.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ee=M.stencil?Eo:uo,Ve=M.stencil?To:zs);let nt={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(nt),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),_=new zi(d.textureWidth,d.textureHeight,{format:ui,type:Ri,depthTexture:new ba(d.textureWidth,d.textureHeight,Ve,void 0,void 0,void 0,void 0,void 0,void 0,Ee),stencilBuffer:M.stencil,colorSpace:e.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{let Ee={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Ee),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),_=new zi(f.framebufferWidth,f.framebufferHeight,{format:ui,type:Ri,colorSpace:e.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}_.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(ee){for(let ne=0;ne<ee.removed.length;ne++){let Ee=ee.removed[ne],Ve=R.indexOf(Ee);Ve>=0&&(R[Ve]=null,I[Ve].disconnect(Ee))}for(let ne=0;ne<ee.added.length;ne++){let Ee=ee.added[ne],Ve=R.indexOf(Ee);if(Ve===-1){for(let nt=0;nt<I.length;nt++)if(nt>=R.length){R.push(Ee),Ve=nt;break}else if(R[nt]===null){R[nt]=Ee,Ve=nt;break}if(Ve===-1)break}let xe=I[Ve];xe&&xe.connect(Ee)}}let Z=new O,ae=new O;function le(ee,ne,Ee){Z.setFromMatrixPosition(ne.matrixWorld),ae.setFromMatrixPosition(Ee.matrixWorld);let Ve=Z.distanceTo(ae),xe=ne.projectionMatrix.elements,nt=Ee.projectionMatrix.elements,Ut=xe[14]/(xe[10]-1),F=xe[14]/(xe[10]+1),gt=(xe[9]+1)/xe[5],je=(xe[9]-1)/xe[5],Xe=(xe[8]-1)/xe[0],Ue=(nt[8]+1)/nt[0],At=Ut*Xe,Ie=Ut*Ue,$e=Ve/(-Xe+Ue),Gt=$e*-Xe;if(ne.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(Gt),ee.translateZ($e),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),xe[10]===-1)ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{let wt=Ut+$e,L=F+$e,x=At-Gt,U=Ie+(Ve-Gt),j=gt*F/L*wt,ie=je*F/L*wt;ee.projectionMatrix.makePerspective(x,U,j,ie,wt,L),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function _e(ee,ne){ne===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ne.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ne=ee.near,Ee=ee.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(Ee=m.depthFar)),B.near=S.near=T.near=ne,B.far=S.far=T.far=Ee,(V!==B.near||$!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),V=B.near,$=B.far),B.layers.mask=ee.layers.mask|6,T.layers.mask=B.layers.mask&3,S.layers.mask=B.layers.mask&5;let Ve=ee.parent,xe=B.cameras;_e(B,Ve);for(let nt=0;nt<xe.length;nt++)_e(xe[nt],Ve);xe.length===2?le(B,T,S):B.projectionMatrix.copy(T.projectionMatrix),Me(ee,B,Ve)};function Me(ee,ne,Ee){Ee===null?ee.matrix.copy(ne.matrixWorld):(ee.matrix.copy(Ee.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ne.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=fo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(ee){return p[ee]};let ve=null;function rt(ee,ne){if(h=ne.getViewerPose(c||o),g=ne,h!==null){let Ee=h.views;f!==null&&(e.setRenderTargetFramebuffer(_,f.framebuffer),e.setRenderTarget(_));let Ve=!1;Ee.length!==B.cameras.length&&(B.cameras.length=0,Ve=!0);for(let F=0;F<Ee.length;F++){let gt=Ee[F],je=null;if(f!==null)je=f.getViewport(gt);else{let Ue=u.getViewSubImage(d,gt);je=Ue.viewport,F===0&&(e.setRenderTargetTextures(_,Ue.colorTexture,Ue.depthStencilTexture),e.setRenderTarget(_))}let Xe=C[F];Xe===void 0&&(Xe=new xn,Xe.layers.enable(F),Xe.viewport=new jt,C[F]=Xe),Xe.matrix.fromArray(gt.transform.matrix),Xe.matrix.decompose(Xe.position,Xe.quaternion,Xe.scale),Xe.projectionMatrix.fromArray(gt.projectionMatrix),Xe.projectionMatrixInverse.copy(Xe.projectionMatrix).invert(),Xe.viewport.set(je.x,je.y,je.width,je.height),F===0&&(B.matrix.copy(Xe.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Ve===!0&&B.cameras.push(Xe)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){u=n.getBinding();let F=u.getDepthInformation(Ee[0]);F&&F.isValid&&F.texture&&m.init(F,s.renderState)}if(xe&&xe.includes("camera-access")&&v){e.state.unbindTexture(),u=n.getBinding();for(let F=0;F<Ee.length;F++){let gt=Ee[F].camera;if(gt){let je=p[gt];je||(je=new wa,p[gt]=je);let Xe=u.getCameraImage(gt);je.sourceTexture=Xe}}}}for(let Ee=0;Ee<I.length;Ee++){let Ve=R[Ee],xe=I[Ee];Ve!==null&&xe!==void 0&&xe.update(Ve,ne,c||o)}ve&&ve(ee,ne),ne.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ne}),g=null}let et=new Q0;et.setAnimationLoop(rt),this.setAnimationLoop=function(ee){ve=ee},this.dispose=function(){}}},Sr=new Kn,u1=new Tt;function d1(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Pf(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,M,b,_){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,_)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,M,b):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===On&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===On&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let M=e.get(p),b=M.envMap,_=M.envMapRotation;b&&(m.envMap.value=b,Sr.copy(_),Sr.x*=-1,Sr.y*=-1,Sr.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&(Sr.y*=-1,Sr.z*=-1),m.envMapRotation.value.setFromMatrix4(u1.makeRotationFromEuler(Sr)),m.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,M,b){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*M,m.scale.value=b*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,M){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===On&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let M=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function f1(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,b){let _=b.program;n.uniformBlockBinding(M,_)}function c(M,b){let _=s[M.id];_===void 0&&(g(M),_=h(M),s[M.id]=_,M.addEventListener("dispose",m));let I=b.program;n.updateUBOMapping(M,I);let R=e.render.frame;r[M.id]!==R&&(d(M),r[M.id]=R)}function h(M){let b=u();M.__bindingPointIndex=b;let _=i.createBuffer(),I=M.__size,R=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,_),i.bufferData(i.UNIFORM_BUFFER,I,R),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,b,_),_}function u(){for(let M=0;M<a;M++)if(o.indexOf(M)===-1)return o.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){let b=s[M.id],_=M.uniforms,I=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let R=0,D=_.length;R<D;R++){let N=Array.isArray(_[R])?_[R]:[_[R]];for(let T=0,S=N.length;T<S;T++){let C=N[T];if(f(C,R,T,I)===!0){let B=C.__offset,V=Array.isArray(C.value)?C.value:[C.value],$=0;for(let X=0;X<V.length;X++){let q=V[X],Q=v(q);typeof q=="number"||typeof q=="boolean"?(C.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,B+$,C.__data)):q.isMatrix3?(C.__data[0]=q.elements[0],C.__data[1]=q.elements[1],C.__data[2]=q.elements[2],C.__data[3]=0,C.__data[4]=q.elements[3],C.__data[5]=q.elements[4],C.__data[6]=q.elements[5],C.__data[7]=0,C.__data[8]=q.elements[6],C.__data[9]=q.elements[7],C.__data[10]=q.elements[8],C.__data[11]=0):(q.toArray(C.__data,$),$+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,B,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(M,b,_,I){let R=M.value,D=b+"_"+_;if(I[D]===void 0)return typeof R=="number"||typeof R=="boolean"?I[D]=R:I[D]=R.clone(),!0;{let N=I[D];if(typeof R=="number"||typeof R=="boolean"){if(N!==R)return I[D]=R,!0}else if(N.equals(R)===!1)return N.copy(R),!0}return!1}function g(M){let b=M.uniforms,_=0,I=16;for(let D=0,N=b.length;D<N;D++){let T=Array.isArray(b[D])?b[D]:[b[D]];for(let S=0,C=T.length;S<C;S++){let B=T[S],V=Array.isArray(B.value)?B.value:[B.value];for(let $=0,X=V.length;$<X;$++){let q=V[$],Q=v(q),Z=_%I,ae=Z%Q.boundary,le=Z+ae;_+=ae,le!==0&&I-le<Q.storage&&(_+=I-le),B.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=_,_+=Q.storage}}}let R=_%I;return R>0&&(_+=I-R),M.__size=_,M.__cache={},this}function v(M){let b={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(b.boundary=4,b.storage=4):M.isVector2?(b.boundary=8,b.storage=8):M.isVector3||M.isColor?(b.boundary=16,b.storage=12):M.isVector4?(b.boundary=16,b.storage=16):M.isMatrix3?(b.boundary=48,b.storage=48):M.isMatrix4?(b.boundary=64,b.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),b}function m(M){let b=M.target;b.removeEventListener("dispose",m);let _=o.indexOf(b.__bindingPointIndex);o.splice(_,1),i.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function p(){for(let M in s)i.deleteBuffer(s[M]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var Po=class{constructor(e={}){let{canvas:t=b0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=o;let g=new Uint32Array(4),v=new Int32Array(4),m=null,p=null,M=[],b=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let _=this,I=!1;this._outputColorSpace=Ht;let R=0,D=0,N=null,T=-1,S=null,C=new jt,B=new jt,V=null,$=new Ke(0),X=0,q=t.width,Q=t.height,Z=1,ae=null,le=null,_e=new jt(0,0,q,Q),Me=new jt(0,0,q,Q),ve=!1,rt=new vo,et=!1,ee=!1,ne=new Tt,Ee=new O,Ve=new jt,xe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nt=!1;function Ut(){return N===null?Z:1}let F=n;function gt(E,G){return t.getContext(E,G)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",me,!1),t.addEventListener("webglcontextrestored",Le,!1),t.addEventListener("webglcontextcreationerror",ue,!1),F===null){let G="webgl2";if(F=gt(G,E),F===null)throw gt(G)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let je,Xe,Ue,At,Ie,$e,Gt,wt,L,x,U,j,ie,te,Oe,de,De,Ce,oe,ye,He,ze,be,Qe;function z(){je=new IT(F),je.init(),ze=new l1(F,je),Xe=new ST(F,je,e,ze),Ue=new o1(F,je),Xe.reversedDepthBuffer&&d&&Ue.buffers.depth.setReversed(!0),At=new DT(F),Ie=new qE,$e=new a1(F,je,Ue,Ie,Xe,ze,At),Gt=new ET(_),wt=new PT(_),L=new zw(F),be=new wT(F,L),x=new LT(F,L,At,be),U=new FT(F,x,L,At),oe=new NT(F,Xe,$e),de=new TT(Ie),j=new XE(_,Gt,wt,je,Xe,be,de),ie=new d1(_,Ie),te=new ZE,Oe=new t1(je),Ce=new bT(_,Gt,wt,Ue,U,f,l),De=new s1(_,U,Xe),Qe=new f1(F,At,Xe,Ue),ye=new MT(F,je,At),He=new kT(F,je,At),At.programs=j.programs,_.capabilities=Xe,_.extensions=je,_.properties=Ie,_.renderLists=te,_.shadowMap=De,_.state=Ue,_.info=At}z();let fe=new Yf(_,F);this.xr=fe,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=je.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=je.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Z},this.setPixelRatio=function(E){E!==void 0&&(Z=E,this.setSize(q,Q,!1))},this.getSize=function(E){return E.set(q,Q)},this.setSize=function(E,G,J=!0){if(fe.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=E,Q=G,t.width=Math.floor(E*Z),t.height=Math.floor(G*Z),J===!0&&(t.style.width=E+"px",t.style.height=G+"px"),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(q*Z,Q*Z).floor()},this.setDrawingBufferSize=function(E,G,J){q=E,Q=G,Z=J,t.width=Math.floor(E*J),t.height=Math.floor(G*J),this.setViewport(0,0,E,G)},this.getCurrentViewport=function(E){return E.copy(C)},this.getViewport=function(E){return E.copy(_e)},this.setViewport=function(E,G,J,K){E.isVector4?_e.set(E.x,E.y,E.z,E.w):_e.set(E,G,J,K),Ue.viewport(C.copy(_e).multiplyScalar(Z).round())},this.getScissor=function(E){return E.copy(Me)},this.setScissor=function(E,G,J,K){E.isVector4?Me.set(E.x,E.y,E.z,E.w):Me.set(E,G,J,K),Ue.scissor(B.copy(Me).multiplyScalar(Z).round())},this.getScissorTest=function(){return ve},this.setScissorTest=function(E){Ue.setScissorTest(ve=E)},this.setOpaqueSort=function(E){ae=E},this.setTransparentSort=function(E){le=E},this.getClearColor=function(E){return E.copy(Ce.getClearColor())},this.setClearColor=function(){Ce.setClearColor(...arguments)},this.getClearAlpha=function(){return Ce.getClearAlpha()},this.setClearAlpha=function(){Ce.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,J=!0){let K=0;if(E){let W=!1;if(N!==null){let pe=N.texture.format;W=pe===eh||pe===Qc||pe===Jc}if(W){let pe=N.texture.type,Se=pe===Ri||pe===zs||pe===Mo||pe===To||pe===Kc||pe===jc,Ne=Ce.getClearColor(),Ae=Ce.getClearAlpha(),Ye=Ne.r,Ze=Ne.g,Ge=Ne.b;Se?(g[0]=Ye,g[1]=Ze,g[2]=Ge,g[3]=Ae,F.clearBufferuiv(F.COLOR,0,g)):(v[0]=Ye,v[1]=Ze,v[2]=Ge,v[3]=Ae,F.clearBufferiv(F.COLOR,0,v))}else K|=F.COLOR_BUFFER_BIT}G&&(K|=F.DEPTH_BUFFER_BIT),J&&(K|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",me,!1),t.removeEventListener("webglcontextrestored",Le,!1),t.removeEventListener("webglcontextcreationerror",ue,!1),Ce.dispose(),te.dispose(),Oe.dispose(),Ie.dispose(),Gt.dispose(),wt.dispose(),U.dispose(),be.dispose(),Qe.dispose(),j.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",Dt),fe.removeEventListener("sessionend",Gn),zn.stop()};function me(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),I=!0}function Le(){console.log("THREE.WebGLRenderer: Context Restored."),I=!1;let E=At.autoReset,G=De.enabled,J=De.autoUpdate,K=De.needsUpdate,W=De.type;z(),At.autoReset=E,De.enabled=G,De.autoUpdate=J,De.needsUpdate=K,De.type=W}function ue(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function re(E){let G=E.target;G.removeEventListener("dispose",re),Be(G)}function Be(E){it(E),Ie.remove(E)}function it(E){let G=Ie.get(E).programs;G!==void 0&&(G.forEach(function(J){j.releaseProgram(J)}),E.isShaderMaterial&&j.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,J,K,W,pe){G===null&&(G=xe);let Se=W.isMesh&&W.matrixWorld.determinant()<0,Ne=ji(E,G,J,K,W);Ue.setMaterial(K,Se);let Ae=J.index,Ye=1;if(K.wireframe===!0){if(Ae=x.getWireframeAttribute(J),Ae===void 0)return;Ye=2}let Ze=J.drawRange,Ge=J.attributes.position,lt=Ze.start*Ye,_t=(Ze.start+Ze.count)*Ye;pe!==null&&(lt=Math.max(lt,pe.start*Ye),_t=Math.min(_t,(pe.start+pe.count)*Ye)),Ae!==null?(lt=Math.max(lt,0),_t=Math.min(_t,Ae.count)):Ge!=null&&(lt=Math.max(lt,0),_t=Math.min(_t,Ge.count));let Ot=_t-lt;if(Ot<0||Ot===1/0)return;be.setup(W,K,Ne,J,Ae);let Rt,ot=ye;if(Ae!==null&&(Rt=L.get(Ae),ot=He,ot.setIndex(Rt)),W.isMesh)K.wireframe===!0?(Ue.setLineWidth(K.wireframeLinewidth*Ut()),ot.setMode(F.LINES)):ot.setMode(F.TRIANGLES);else if(W.isLine){let qe=K.linewidth;qe===void 0&&(qe=1),Ue.setLineWidth(qe*Ut()),W.isLineSegments?ot.setMode(F.LINES):W.isLineLoop?ot.setMode(F.LINE_LOOP):ot.setMode(F.LINE_STRIP)}else W.isPoints?ot.setMode(F.POINTS):W.isSprite&&ot.setMode(F.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)po("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ot.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(je.get("WEBGL_multi_draw"))ot.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{let qe=W._multiDrawStarts,Bt=W._multiDrawCounts,pt=W._multiDrawCount,Sn=Ae?L.get(Ae).bytesPerElement:1,vs=Ie.get(K).currentProgram.getUniforms();for(let Pn=0;Pn<pt;Pn++)vs.setValue(F,"_gl_DrawID",Pn),ot.render(qe[Pn]/Sn,Bt[Pn])}else if(W.isInstancedMesh)ot.renderInstances(lt,Ot,W.count);else if(J.isInstancedBufferGeometry){let qe=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Bt=Math.min(J.instanceCount,qe);ot.renderInstances(lt,Ot,Bt)}else ot.render(lt,Ot)};function It(E,G,J){E.transparent===!0&&E.side===hi&&E.forceSinglePass===!1?(E.side=On,E.needsUpdate=!0,$s(E,G,J),E.side=ls,E.needsUpdate=!0,$s(E,G,J),E.side=hi):$s(E,G,J)}this.compile=function(E,G,J=null){J===null&&(J=E),p=Oe.get(J),p.init(G),b.push(p),J.traverseVisible(function(W){W.isLight&&W.layers.test(G.layers)&&(p.pushLight(W),W.castShadow&&p.pushShadow(W))}),E!==J&&E.traverseVisible(function(W){W.isLight&&W.layers.test(G.layers)&&(p.pushLight(W),W.castShadow&&p.pushShadow(W))}),p.setupLights();let K=new Set;return E.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;let pe=W.material;if(pe)if(Array.isArray(pe))for(let Se=0;Se<pe.length;Se++){let Ne=pe[Se];It(Ne,J,W),K.add(Ne)}else It(pe,J,W),K.add(pe)}),p=b.pop(),K},this.compileAsync=function(E,G,J=null){let K=this.compile(E,G,J);return new Promise(W=>{function pe(){if(K.forEach(function(Se){Ie.get(Se).currentProgram.isReady()&&K.delete(Se)}),K.size===0){W(E);return}setTimeout(pe,10)}je.get("KHR_parallel_shader_compile")!==null?pe():setTimeout(pe,10)})};let vt=null;function bn(E){vt&&vt(E)}function Dt(){zn.stop()}function Gn(){zn.start()}let zn=new Q0;zn.setAnimationLoop(bn),typeof self<"u"&&zn.setContext(self),this.setAnimationLoop=function(E){vt=E,fe.setAnimationLoop(E),E===null?zn.stop():zn.start()},fe.addEventListener("sessionstart",Dt),fe.addEventListener("sessionend",Gn),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(G),G=fe.getCamera()),E.isScene===!0&&E.onBeforeRender(_,E,G,N),p=Oe.get(E,b.length),p.init(G),b.push(p),ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),rt.setFromProjectionMatrix(ne,Mi,G.reversedDepth),ee=this.localClippingEnabled,et=de.init(this.clippingPlanes,ee),m=te.get(E,M.length),m.init(),M.push(m),fe.enabled===!0&&fe.isPresenting===!0){let pe=_.xr.getDepthSensingMesh();pe!==null&&Li(pe,G,-1/0,_.sortObjects)}Li(E,G,0,_.sortObjects),m.finish(),_.sortObjects===!0&&m.sort(ae,le),nt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,nt&&Ce.addToRenderList(m,E),this.info.render.frame++,et===!0&&de.beginShadows();let J=p.state.shadowsArray;De.render(J,E,G),et===!0&&de.endShadows(),this.info.autoReset===!0&&this.info.reset();let K=m.opaque,W=m.transmissive;if(p.setupLights(),G.isArrayCamera){let pe=G.cameras;if(W.length>0)for(let Se=0,Ne=pe.length;Se<Ne;Se++){let Ae=pe[Se];Ki(K,W,E,Ae)}nt&&Ce.render(E);for(let Se=0,Ne=pe.length;Se<Ne;Se++){let Ae=pe[Se];Cn(m,E,Ae,Ae.viewport)}}else W.length>0&&Ki(K,W,E,G),nt&&Ce.render(E),Cn(m,E,G);N!==null&&D===0&&($e.updateMultisampleRenderTarget(N),$e.updateRenderTargetMipmap(N)),E.isScene===!0&&E.onAfterRender(_,E,G),be.resetDefaultState(),T=-1,S=null,b.pop(),b.length>0?(p=b[b.length-1],et===!0&&de.setGlobalState(_.clippingPlanes,p.state.camera)):p=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function Li(E,G,J,K){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)J=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||rt.intersectsSprite(E)){K&&Ve.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ne);let Se=U.update(E),Ne=E.material;Ne.visible&&m.push(E,Se,Ne,J,Ve.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||rt.intersectsObject(E))){let Se=U.update(E),Ne=E.material;if(K&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ve.copy(E.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),Ve.copy(Se.boundingSphere.center)),Ve.applyMatrix4(E.matrixWorld).applyMatrix4(ne)),Array.isArray(Ne)){let Ae=Se.groups;for(let Ye=0,Ze=Ae.length;Ye<Ze;Ye++){let Ge=Ae[Ye],lt=Ne[Ge.materialIndex];lt&&lt.visible&&m.push(E,Se,lt,J,Ve.z,Ge)}}else Ne.visible&&m.push(E,Se,Ne,J,Ve.z,null)}}let pe=E.children;for(let Se=0,Ne=pe.length;Se<Ne;Se++)Li(pe[Se],G,J,K)}function Cn(E,G,J,K){let W=E.opaque,pe=E.transmissive,Se=E.transparent;p.setupLightsView(J),et===!0&&de.setGlobalState(_.clippingPlanes,J),K&&Ue.viewport(C.copy(K)),W.length>0&&yi(W,G,J),pe.length>0&&yi(pe,G,J),Se.length>0&&yi(Se,G,J),Ue.buffers.depth.setTest(!0),Ue.buffers.depth.setMask(!0),Ue.buffers.color.setMask(!0),Ue.setPolygonOffset(!1)}function Ki(E,G,J,K){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[K.id]===void 0&&(p.state.transmissionRenderTarget[K.id]=new zi(1,1,{generateMipmaps:!0,type:je.has("EXT_color_buffer_half_float")||je.has("EXT_color_buffer_float")?So:Ri,minFilter:Bs,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:yt.workingColorSpace}));let pe=p.state.transmissionRenderTarget[K.id],Se=K.viewport||C;pe.setSize(Se.z*_.transmissionResolutionScale,Se.w*_.transmissionResolutionScale);let Ne=_.getRenderTarget(),Ae=_.getActiveCubeFace(),Ye=_.getActiveMipmapLevel();_.setRenderTarget(pe),_.getClearColor($),X=_.getClearAlpha(),X<1&&_.setClearColor(16777215,.5),_.clear(),nt&&Ce.render(J);let Ze=_.toneMapping;_.toneMapping=fs;let Ge=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),p.setupLightsView(K),et===!0&&de.setGlobalState(_.clippingPlanes,K),yi(E,J,K),$e.updateMultisampleRenderTarget(pe),$e.updateRenderTargetMipmap(pe),je.has("WEBGL_multisampled_render_to_texture")===!1){let lt=!1;for(let _t=0,Ot=G.length;_t<Ot;_t++){let Rt=G[_t],ot=Rt.object,qe=Rt.geometry,Bt=Rt.material,pt=Rt.group;if(Bt.side===hi&&ot.layers.test(K.layers)){let Sn=Bt.side;Bt.side=On,Bt.needsUpdate=!0,$o(ot,J,K,qe,Bt,pt),Bt.side=Sn,Bt.needsUpdate=!0,lt=!0}}lt===!0&&($e.updateMultisampleRenderTarget(pe),$e.updateRenderTargetMipmap(pe))}_.setRenderTarget(Ne,Ae,Ye),_.setClearColor($,X),Ge!==void 0&&(K.viewport=Ge),_.toneMapping=Ze}function yi(E,G,J){let K=G.isScene===!0?G.overrideMaterial:null;for(let W=0,pe=E.length;W<pe;W++){let Se=E[W],Ne=Se.object,Ae=Se.geometry,Ye=Se.group,Ze=Se.material;Ze.allowOverride===!0&&K!==null&&(Ze=K),Ne.layers.test(J.layers)&&$o(Ne,G,J,Ae,Ze,Ye)}}function $o(E,G,J,K,W,pe){E.onBeforeRender(_,G,J,K,W,pe),E.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),W.onBeforeRender(_,G,J,K,E,pe),W.transparent===!0&&W.side===hi&&W.forceSinglePass===!1?(W.side=On,W.needsUpdate=!0,_.renderBufferDirect(J,G,K,W,E,pe),W.side=ls,W.needsUpdate=!0,_.renderBufferDirect(J,G,K,W,E,pe),W.side=hi):_.renderBufferDirect(J,G,K,W,E,pe),E.onAfterRender(_,G,J,K,W,pe)}function $s(E,G,J){G.isScene!==!0&&(G=xe);let K=Ie.get(E),W=p.state.lights,pe=p.state.shadowsArray,Se=W.state.version,Ne=j.getParameters(E,W.state,pe,G,J),Ae=j.getProgramCacheKey(Ne),Ye=K.programs;K.environment=E.isMeshStandardMaterial?G.environment:null,K.fog=G.fog,K.envMap=(E.isMeshStandardMaterial?wt:Gt).get(E.envMap||K.environment),K.envMapRotation=K.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,Ye===void 0&&(E.addEventListener("dispose",re),Ye=new Map,K.programs=Ye);let Ze=Ye.get(Ae);if(Ze!==void 0){if(K.currentProgram===Ze&&K.lightsStateVersion===Se)return gl(E,Ne),Ze}else Ne.uniforms=j.getUniforms(E),E.onBeforeCompile(Ne,_),Ze=j.acquireProgram(Ne,Ae),Ye.set(Ae,Ze),K.uniforms=Ne.uniforms;let Ge=K.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ge.clippingPlanes=de.uniform),gl(E,Ne),K.needsLights=Xs(E),K.lightsStateVersion=Se,K.needsLights&&(Ge.ambientLightColor.value=W.state.ambient,Ge.lightProbe.value=W.state.probe,Ge.directionalLights.value=W.state.directional,Ge.directionalLightShadows.value=W.state.directionalShadow,Ge.spotLights.value=W.state.spot,Ge.spotLightShadows.value=W.state.spotShadow,Ge.rectAreaLights.value=W.state.rectArea,Ge.ltc_1.value=W.state.rectAreaLTC1,Ge.ltc_2.value=W.state.rectAreaLTC2,Ge.pointLights.value=W.state.point,Ge.pointLightShadows.value=W.state.pointShadow,Ge.hemisphereLights.value=W.state.hemi,Ge.directionalShadowMap.value=W.state.directionalShadowMap,Ge.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Ge.spotShadowMap.value=W.state.spotShadowMap,Ge.spotLightMatrix.value=W.state.spotLightMatrix,Ge.spotLightMap.value=W.state.spotLightMap,Ge.pointShadowMap.value=W.state.pointShadowMap,Ge.pointShadowMatrix.value=W.state.pointShadowMatrix),K.currentProgram=Ze,K.uniformsList=null,Ze}function ml(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=Co.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function gl(E,G){let J=Ie.get(E);J.outputColorSpace=G.outputColorSpace,J.batching=G.batching,J.batchingColor=G.batchingColor,J.instancing=G.instancing,J.instancingColor=G.instancingColor,J.instancingMorph=G.instancingMorph,J.skinning=G.skinning,J.morphTargets=G.morphTargets,J.morphNormals=G.morphNormals,J.morphColors=G.morphColors,J.morphTargetsCount=G.morphTargetsCount,J.numClippingPlanes=G.numClippingPlanes,J.numIntersection=G.numClipIntersection,J.vertexAlphas=G.vertexAlphas,J.vertexTangents=G.vertexTangents,J.toneMapping=G.toneMapping}function ji(E,G,J,K,W){G.isScene!==!0&&(G=xe),$e.resetTextureUnits();let pe=G.fog,Se=K.isMeshStandardMaterial?G.environment:null,Ne=N===null?_.outputColorSpace:N.isXRRenderTarget===!0?N.texture.colorSpace:lr,Ae=(K.isMeshStandardMaterial?wt:Gt).get(K.envMap||Se),Ye=K.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,Ze=!!J.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ge=!!J.morphAttributes.position,lt=!!J.morphAttributes.normal,_t=!!J.morphAttributes.color,Ot=fs;K.toneMapped&&(N===null||N.isXRRenderTarget===!0)&&(Ot=_.toneMapping);let Rt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,ot=Rt!==void 0?Rt.length:0,qe=Ie.get(K),Bt=p.state.lights;if(et===!0&&(ee===!0||E!==S)){let fn=E===S&&K.id===T;de.setState(K,E,fn)}let pt=!1;K.version===qe.__version?(qe.needsLights&&qe.lightsStateVersion!==Bt.state.version||qe.outputColorSpace!==Ne||W.isBatchedMesh&&qe.batching===!1||!W.isBatchedMesh&&qe.batching===!0||W.isBatchedMesh&&qe.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&qe.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&qe.instancing===!1||!W.isInstancedMesh&&qe.instancing===!0||W.isSkinnedMesh&&qe.skinning===!1||!W.isSkinnedMesh&&qe.skinning===!0||W.isInstancedMesh&&qe.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&qe.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&qe.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&qe.instancingMorph===!1&&W.morphTexture!==null||qe.envMap!==Ae||K.fog===!0&&qe.fog!==pe||qe.numClippingPlanes!==void 0&&(qe.numClippingPlanes!==de.numPlanes||qe.numIntersection!==de.numIntersection)||qe.vertexAlphas!==Ye||qe.vertexTangents!==Ze||qe.morphTargets!==Ge||qe.morphNormals!==lt||qe.morphColors!==_t||qe.toneMapping!==Ot||qe.morphTargetsCount!==ot)&&(pt=!0):(pt=!0,qe.__version=K.version);let Sn=qe.currentProgram;pt===!0&&(Sn=$s(K,G,W));let vs=!1,Pn=!1,qs=!1,zt=Sn.getUniforms(),In=qe.uniforms;if(Ue.useProgram(Sn.program)&&(vs=!0,Pn=!0,qs=!0),K.id!==T&&(T=K.id,Pn=!0),vs||S!==E){Ue.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),zt.setValue(F,"projectionMatrix",E.projectionMatrix),zt.setValue(F,"viewMatrix",E.matrixWorldInverse);let pn=zt.map.cameraPosition;pn!==void 0&&pn.setValue(F,Ee.setFromMatrixPosition(E.matrixWorld)),Xe.logarithmicDepthBuffer&&zt.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&zt.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,Pn=!0,qs=!0)}if(W.isSkinnedMesh){zt.setOptional(F,W,"bindMatrix"),zt.setOptional(F,W,"bindMatrixInverse");let fn=W.skeleton;fn&&(fn.boneTexture===null&&fn.computeBoneTexture(),zt.setValue(F,"boneTexture",fn.boneTexture,$e))}W.isBatchedMesh&&(zt.setOptional(F,W,"batchingTexture"),zt.setValue(F,"batchingTexture",W._matricesTexture,$e),zt.setOptional(F,W,"batchingIdTexture"),zt.setValue(F,"batchingIdTexture",W._indirectTexture,$e),zt.setOptional(F,W,"batchingColorTexture"),W._colorsTexture!==null&&zt.setValue(F,"batchingColorTexture",W._colorsTexture,$e));let Hn=J.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&oe.update(W,J,Sn),(Pn||qe.receiveShadow!==W.receiveShadow)&&(qe.receiveShadow=W.receiveShadow,zt.setValue(F,"receiveShadow",W.receiveShadow)),K.isMeshGouraudMaterial&&K.envMap!==null&&(In.envMap.value=Ae,In.flipEnvMap.value=Ae.isCubeTexture&&Ae.isRenderTargetTexture===!1?-1:1),K.isMeshStandardMaterial&&K.envMap===null&&G.environment!==null&&(In.envMapIntensity.value=G.environmentIntensity),Pn&&(zt.setValue(F,"toneMappingExposure",_.toneMappingExposure),qe.needsLights&&nd(In,qs),pe&&K.fog===!0&&ie.refreshFogUniforms(In,pe),ie.refreshMaterialUniforms(In,K,Z,Q,p.state.transmissionRenderTarget[E.id]),Co.upload(F,ml(qe),In,$e)),K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(Co.upload(F,ml(qe),In,$e),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&zt.setValue(F,"center",W.center),zt.setValue(F,"modelViewMatrix",W.modelViewMatrix),zt.setValue(F,"normalMatrix",W.normalMatrix),zt.setValue(F,"modelMatrix",W.matrixWorld),K.isShaderMaterial||K.isRawShaderMaterial){let fn=K.uniformsGroups;for(let pn=0,_s=fn.length;pn<_s;pn++){let si=fn[pn];Qe.update(si,Sn),Qe.bind(si,Sn)}}return Sn}function nd(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function Xs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return N},this.setRenderTargetTextures=function(E,G,J){let K=Ie.get(E);K.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Ie.get(E.texture).__webglTexture=G,Ie.get(E.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:J,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let J=Ie.get(E);J.__webglFramebuffer=G,J.__useDefaultFramebuffer=G===void 0};let yl=F.createFramebuffer();this.setRenderTarget=function(E,G=0,J=0){N=E,R=G,D=J;let K=!0,W=null,pe=!1,Se=!1;if(E){let Ae=Ie.get(E);if(Ae.__useDefaultFramebuffer!==void 0)Ue.bindFramebuffer(F.FRAMEBUFFER,null),K=!1;else if(Ae.__webglFramebuffer===void 0)$e.setupRenderTarget(E);else if(Ae.__hasExternalTextures)$e.rebindTextures(E,Ie.get(E.texture).__webglTexture,Ie.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Ge=E.depthTexture;if(Ae.__boundDepthTexture!==Ge){if(Ge!==null&&Ie.has(Ge)&&(E.width!==Ge.image.width||E.height!==Ge.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(E)}}let Ye=E.texture;(Ye.isData3DTexture||Ye.isDataArrayTexture||Ye.isCompressedArrayTexture)&&(Se=!0);let Ze=Ie.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ze[G])?W=Ze[G][J]:W=Ze[G],pe=!0):E.samples>0&&$e.useMultisampledRTT(E)===!1?W=Ie.get(E).__webglMultisampledFramebuffer:Array.isArray(Ze)?W=Ze[J]:W=Ze,C.copy(E.viewport),B.copy(E.scissor),V=E.scissorTest}else C.copy(_e).multiplyScalar(Z).floor(),B.copy(Me).multiplyScalar(Z).floor(),V=ve;if(J!==0&&(W=yl),Ue.bindFramebuffer(F.FRAMEBUFFER,W)&&K&&Ue.drawBuffers(E,W),Ue.viewport(C),Ue.scissor(B),Ue.setScissorTest(V),pe){let Ae=Ie.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+G,Ae.__webglTexture,J)}else if(Se){let Ae=G;for(let Ye=0;Ye<E.textures.length;Ye++){let Ze=Ie.get(E.textures[Ye]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+Ye,Ze.__webglTexture,J,Ae)}}else if(E!==null&&J!==0){let Ae=Ie.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ae.__webglTexture,J)}T=-1},this.readRenderTargetPixels=function(E,G,J,K,W,pe,Se,Ne=0){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ae=Ie.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(Ae=Ae[Se]),Ae){Ue.bindFramebuffer(F.FRAMEBUFFER,Ae);try{let Ye=E.textures[Ne],Ze=Ye.format,Ge=Ye.type;if(!Xe.textureFormatReadable(Ze)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Xe.textureTypeReadable(Ge)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-K&&J>=0&&J<=E.height-W&&(E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ne),F.readPixels(G,J,K,W,ze.convert(Ze),ze.convert(Ge),pe))}finally{let Ye=N!==null?Ie.get(N).__webglFramebuffer:null;Ue.bindFramebuffer(F.FRAMEBUFFER,Ye)}}},this.readRenderTargetPixelsAsync=async function(E,G,J,K,W,pe,Se,Ne=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ae=Ie.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(Ae=Ae[Se]),Ae)if(G>=0&&G<=E.width-K&&J>=0&&J<=E.height-W){Ue.bindFramebuffer(F.FRAMEBUFFER,Ae);let Ye=E.textures[Ne],Ze=Ye.format,Ge=Ye.type;if(!Xe.textureFormatReadable(Ze))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Xe.textureTypeReadable(Ge))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,lt),F.bufferData(F.PIXEL_PACK_BUFFER,pe.byteLength,F.STREAM_READ),E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ne),F.readPixels(G,J,K,W,ze.convert(Ze),ze.convert(Ge),0);let _t=N!==null?Ie.get(N).__webglFramebuffer:null;Ue.bindFramebuffer(F.FRAMEBUFFER,_t);let Ot=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await w0(F,Ot,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,lt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,pe),F.deleteBuffer(lt),F.deleteSync(Ot),pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,J=0){let K=Math.pow(2,-J),W=Math.floor(E.image.width*K),pe=Math.floor(E.image.height*K),Se=G!==null?G.x:0,Ne=G!==null?G.y:0;$e.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,J,0,0,Se,Ne,W,pe),Ue.unbindTexture()};let ki=F.createFramebuffer(),rn=F.createFramebuffer();this.copyTextureToTexture=function(E,G,J=null,K=null,W=0,pe=null){pe===null&&(W!==0?(po("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),pe=W,W=0):pe=0);let Se,Ne,Ae,Ye,Ze,Ge,lt,_t,Ot,Rt=E.isCompressedTexture?E.mipmaps[pe]:E.image;if(J!==null)Se=J.max.x-J.min.x,Ne=J.max.y-J.min.y,Ae=J.isBox3?J.max.z-J.min.z:1,Ye=J.min.x,Ze=J.min.y,Ge=J.isBox3?J.min.z:0;else{let Hn=Math.pow(2,-W);Se=Math.floor(Rt.width*Hn),Ne=Math.floor(Rt.height*Hn),E.isDataArrayTexture?Ae=Rt.depth:E.isData3DTexture?Ae=Math.floor(Rt.depth*Hn):Ae=1,Ye=0,Ze=0,Ge=0}K!==null?(lt=K.x,_t=K.y,Ot=K.z):(lt=0,_t=0,Ot=0);let ot=ze.convert(G.format),qe=ze.convert(G.type),Bt;G.isData3DTexture?($e.setTexture3D(G,0),Bt=F.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?($e.setTexture2DArray(G,0),Bt=F.TEXTURE_2D_ARRAY):($e.setTexture2D(G,0),Bt=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,G.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,G.unpackAlignment);let pt=F.getParameter(F.UNPACK_ROW_LENGTH),Sn=F.getParameter(F.UNPACK_IMAGE_HEIGHT),vs=F.getParameter(F.UNPACK_SKIP_PIXELS),Pn=F.getParameter(F.UNPACK_SKIP_ROWS),qs=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,Rt.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Rt.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Ye),F.pixelStorei(F.UNPACK_SKIP_ROWS,Ze),F.pixelStorei(F.UNPACK_SKIP_IMAGES,Ge);let zt=E.isDataArrayTexture||E.isData3DTexture,In=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let Hn=Ie.get(E),fn=Ie.get(G),pn=Ie.get(Hn.__renderTarget),_s=Ie.get(fn.__renderTarget);Ue.bindFramebuffer(F.READ_FRAMEBUFFER,pn.__webglFramebuffer),Ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,_s.__webglFramebuffer);for(let si=0;si<Ae;si++)zt&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ie.get(E).__webglTexture,W,Ge+si),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ie.get(G).__webglTexture,pe,Ot+si)),F.blitFramebuffer(Ye,Ze,Se,Ne,lt,_t,Se,Ne,F.DEPTH_BUFFER_BIT,F.NEAREST);Ue.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(W!==0||E.isRenderTargetTexture||Ie.has(E)){let Hn=Ie.get(E),fn=Ie.get(G);Ue.bindFramebuffer(F.READ_FRAMEBUFFER,ki),Ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,rn);for(let pn=0;pn<Ae;pn++)zt?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Hn.__webglTexture,W,Ge+pn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Hn.__webglTexture,W),In?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,fn.__webglTexture,pe,Ot+pn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,fn.__webglTexture,pe),W!==0?F.blitFramebuffer(Ye,Ze,Se,Ne,lt,_t,Se,Ne,F.COLOR_BUFFER_BIT,F.NEAREST):In?F.copyTexSubImage3D(Bt,pe,lt,_t,Ot+pn,Ye,Ze,Se,Ne):F.copyTexSubImage2D(Bt,pe,lt,_t,Ye,Ze,Se,Ne);Ue.bindFramebuffer(F.READ_FRAMEBUFFER,null),Ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else In?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(Bt,pe,lt,_t,Ot,Se,Ne,Ae,ot,qe,Rt.data):G.isCompressedArrayTexture?F.compressedTexSubImage3D(Bt,pe,lt,_t,Ot,Se,Ne,Ae,ot,Rt.data):F.texSubImage3D(Bt,pe,lt,_t,Ot,Se,Ne,Ae,ot,qe,Rt):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,pe,lt,_t,Se,Ne,ot,qe,Rt.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,pe,lt,_t,Rt.width,Rt.height,ot,Rt.data):F.texSubImage2D(F.TEXTURE_2D,pe,lt,_t,Se,Ne,ot,qe,Rt);F.pixelStorei(F.UNPACK_ROW_LENGTH,pt),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Sn),F.pixelStorei(F.UNPACK_SKIP_PIXELS,vs),F.pixelStorei(F.UNPACK_SKIP_ROWS,Pn),F.pixelStorei(F.UNPACK_SKIP_IMAGES,qs),pe===0&&G.generateMipmaps&&F.generateMipmap(Bt),Ue.unbindTexture()},this.initRenderTarget=function(E){Ie.get(E).__webglFramebuffer===void 0&&$e.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?$e.setTextureCube(E,0):E.isData3DTexture?$e.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?$e.setTexture2DArray(E,0):$e.setTexture2D(E,0),Ue.unbindTexture()},this.resetState=function(){R=0,D=0,N=null,Ue.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var sy={type:"change"},jf={type:"start"},oy={type:"end"},Dh=new Ds,ry=new li,p1=Math.cos(70*Xa.DEG2RAD),cn=new O,Vn=2*Math.PI,kt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Kf=1e-6,Nh=class extends Ba{constructor(e,t=null){super(e,t),this.state=kt.NONE,this.target=new O,this.cursor=new O,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ei.ROTATE,MIDDLE:Ei.DOLLY,RIGHT:Ei.PAN},this.touches={ONE:Ai.ROTATE,TWO:Ai.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new O,this._lastQuaternion=new en,this._lastTargetPosition=new O,this._quat=new en().setFromUnitVectors(e.up,new O(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new wo,this._sphericalDelta=new wo,this._scale=1,this._panOffset=new O,this._rotateStart=new we,this._rotateEnd=new we,this._rotateDelta=new we,this._panStart=new we,this._panEnd=new we,this._panDelta=new we,this._dollyStart=new we,this._dollyEnd=new we,this._dollyDelta=new we,this._dollyDirection=new O,this._mouse=new we,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=g1.bind(this),this._onPointerDown=m1.bind(this),this._onPointerUp=y1.bind(this),this._onContextMenu=S1.bind(this),this._onMouseWheel=x1.bind(this),this._onKeyDown=b1.bind(this),this._onTouchStart=w1.bind(this),this._onTouchMove=M1.bind(this),this._onMouseDown=v1.bind(this),this._onMouseMove=_1.bind(this),this._interceptControlDown=T1.bind(this),this._interceptControlUp=E1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(sy),this.update(),this.state=kt.NONE}update(e=null){let t=this.object.position;cn.copy(t).sub(this.target),cn.applyQuaternion(this._quat),this._spherical.setFromVector3(cn),this.autoRotate&&this.state===kt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Vn:n>Math.PI&&(n-=Vn),s<-Math.PI?s+=Vn:s>Math.PI&&(s-=Vn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(cn.setFromSpherical(this._spherical),cn.applyQuaternion(this._quatInverse),t.copy(this.target).add(cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new O(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new O(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Dh.origin.copy(this.object.position),Dh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Dh.direction))<p1?this.object.lookAt(this.target):(ry.setFromNormalAndCoplanarPoint(this.object.up,this.target),Dh.intersectPlane(ry,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Kf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Kf||this._lastTargetPosition.distanceToSquared(this.target)>Kf?(this.dispatchEvent(sy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Vn/60*this.autoRotateSpeed*e:Vn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){cn.setFromMatrixColumn(t,0),cn.multiplyScalar(-e),this._panOffset.add(cn)}_panUp(e,t){this.screenSpacePanning===!0?cn.setFromMatrixColumn(t,1):(cn.setFromMatrixColumn(t,0),cn.crossVectors(this.object.up,cn)),cn.multiplyScalar(e),this._panOffset.add(cn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;cn.copy(s).sub(this.target);let r=cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Vn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Vn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Vn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Vn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Vn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Vn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Vn*this._rotateDelta.x/t.clientHeight),this._rotateUp(Vn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new we,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function m1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function g1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function y1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(oy),this.state=kt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function v1(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Ei.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=kt.DOLLY;break;case Ei.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=kt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=kt.ROTATE}break;case Ei.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=kt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=kt.PAN}break;default:this.state=kt.NONE}this.state!==kt.NONE&&this.dispatchEvent(jf)}function _1(i){switch(this.state){case kt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case kt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case kt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function x1(i){this.enabled===!1||this.enableZoom===!1||this.state!==kt.NONE||(i.preventDefault(),this.dispatchEvent(jf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(oy))}function b1(i){this.enabled!==!1&&this._handleKeyDown(i)}function w1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ai.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=kt.TOUCH_ROTATE;break;case Ai.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=kt.TOUCH_PAN;break;default:this.state=kt.NONE}break;case 2:switch(this.touches.TWO){case Ai.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=kt.TOUCH_DOLLY_PAN;break;case Ai.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=kt.TOUCH_DOLLY_ROTATE;break;default:this.state=kt.NONE}break;default:this.state=kt.NONE}this.state!==kt.NONE&&this.dispatchEvent(jf)}function M1(i){switch(this._trackPointer(i),this.state){case kt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case kt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case kt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case kt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=kt.NONE}}function S1(i){this.enabled!==!1&&i.preventDefault()}function T1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function E1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ay(i){let e=[...i].sort((s,r)=>s[0]-r[0]||s[1]-r[1]),t=(s,r,o)=>(r[0]-s[0])*(o[1]-s[1])-(r[1]-s[1])*(o[0]-s[0])>1e-12,n=s=>{let r=[];for(let o of s){for(;r.length>=2&&!t(r[r.length-2],r[r.length-1],o);)r.pop();r.push(o)}return r.slice(0,-1)};return e.length<3?e:[...n(e),...n(e.reverse())]}var A1=24,R1=.005,Ya={made:.001,support:.002,planned:.003,marks:.004};function Jf(i,e){let t=new Vt;t.setAttribute("position",new on(new Float32Array(3*i),3));let n=new xa(t,new Gi({color:e}));return n.frustumCulled=!1,n.visible=!1,n}function Qf(i,e,t){let n=i.geometry.getAttribute("position");for(let[s,[r,o]]of e.entries())n.setXYZ(s,r,o,t);n.needsUpdate=!0,i.geometry.setDrawRange(0,e.length),i.visible=e.length>2}function ep(i,e){let t=new ft(new Ma(i,24),new An({color:e,depthTest:!1}));return t.renderOrder=2,t.visible=!1,t}var Fh=class{constructor(e,t,n){this.sole=e;this.size_m=t;this.colours=n;this.grid=this.makeGrid(),this.support=new ft(new Vt,new An({color:n.support,transparent:!0,opacity:.3,depthTest:!1})),this.support.renderOrder=1,this.support.frustumCulled=!1,this.supportEdge=Jf(8,n.support),this.planned=Array.from({length:4},()=>Jf(4,n.planned));let s=t*.028;this.zmp=ep(s,n.zmp),this.plannedZmp=ep(s*.6,n.plannedZmp),this.com=ep(s*.8,n.com),this.comDrop=new ur(new Vt().setFromPoints([new O,new O(0,0,1)]),new Gi({color:n.com})),this.comDrop.visible=!1,this.group.add(this.grid,this.support,this.supportEdge,...this.planned,this.zmp,this.plannedZmp,this.com,this.comDrop)}group=new Ct;grid;support;supportEdge;planned;made=[];zmp;plannedZmp;com;comDrop;gridShown=!0;stood=[!1,!1];setColours(e){this.colours=e,this.group.remove(this.grid),this.grid.dispose(),this.grid=this.makeGrid(),this.group.add(this.grid);let t=(n,s)=>n.material.color.setHex(s);for(let n of this.made)t(n,e.made);for(let n of this.planned)t(n,e.planned);for(let n of[this.support,this.supportEdge])t(n,e.support);t(this.zmp,e.zmp),t(this.plannedZmp,e.plannedZmp);for(let n of[this.com,this.comDrop])t(n,e.com)}hideGrid(){this.gridShown=!1,this.grid.visible=!1}forgetSteps(){this.group.remove(...this.made);for(let{geometry:e}of this.made.splice(0))e.dispose()}show(e,t){let[n=NaN,s=NaN]=e.base_place;if(Number.isNaN(n))return;this.grid.position.set(Math.round(n),Math.round(s),0),this.showSteps(e,n,s),this.showSupport(e,t);let r=(o,a)=>{let[l=NaN,c=NaN]=a;o.visible=!Number.isNaN(l+c),o.visible&&o.position.set(n+l,s+c,Ya.marks)};r(this.zmp,e.zmp),r(this.plannedZmp,e.planned_zmp),r(this.com,e.com),this.comDrop.visible=this.com.visible&&!Number.isNaN(e.com[2]??NaN),this.comDrop.visible&&(this.comDrop.position.copy(this.com.position),this.comDrop.scale.z=e.com[2]??0)}showSteps(e,t,n){let s=e.footstep_count[0]??0;for(let[r,o]of this.planned.entries()){let[a=0,l=0,c=0]=e.footstep.slice(3*r,3*r+3);o.visible=r<s,o.visible&&Qf(o,this.rectangle(t+a,n+l,c),Ya.planned)}}showSupport(e,t){let n=[];for(let r of[0,1]){let o=e.contact[r]===1,a=o?t.soleCorners(r):[],l=a.map(({x:c,y:h})=>[c,h]);n.push(...l),o&&!this.stood[r]&&this.addMade(l,Math.max(...a.map(({z:c})=>c))),this.stood[r]=o}let s=ay(n);Qf(this.supportEdge,s,Ya.support),this.support.visible=s.length>2,this.support.visible&&(this.support.geometry.dispose(),this.support.geometry=new Ns(new hs(s.map(([r,o])=>new we(r,o)))),this.support.position.z=Ya.support)}addMade(e,t){let n=this.made.length<A1?Jf(4,this.colours.made):this.made.shift();n&&(this.made.push(n),this.group.add(n),Qf(n,e,Ya.made+(t>R1?t:0)))}rectangle(e,t,n){let{length:s,width:r,ahead:o}=this.sole,[a,l]=[Math.cos(n),Math.sin(n)];return[[o+s/2,r/2],[o-s/2,r/2],[o-s/2,-r/2],[o+s/2,-r/2]].map(([h,u])=>[e+a*h-l*u,t+l*h+a*u])}makeGrid(){let e=2*Math.ceil(this.size_m*5),t=new vr(e,e*4,this.colours.grid,this.colours.grid);return t.rotation.x=Math.PI/2,t.visible=this.gridShown,t}};var Uh=class{last_ms=-1/0;drawn_ms=[];windowBegan_ms=-1/0;wished=0;drawn=0;goodWindows=0;fineness=1;total=0;isDue(e){return e-this.last_ms>=30}wish(){this.wished+=1}drew(e){for(this.last_ms=e,this.drawn_ms.push(e);(this.drawn_ms[0]??e)<e-1e3;)this.drawn_ms.shift();if(this.drawn+=1,this.total+=1,e-this.windowBegan_ms<2e3)return!1;let n=this.windowBegan_ms>-1/0&&e-this.windowBegan_ms<2*2e3&&this.judge(this.drawn/Math.max(this.wished,1),this.wished*1e3/(e-this.windowBegan_ms));return this.windowBegan_ms=e,this.wished=this.drawn=0,n}get perSecond(){return this.drawn_ms.length}judge(e,t){let n=this.fineness;return this.goodWindows=e>.9?this.goodWindows+1:0,e<.75&&t>20&&(this.fineness=Math.max(this.fineness*.8,.5)),this.goodWindows>=10&&(this.goodWindows=0,this.fineness=Math.min(this.fineness/.8,1)),this.fineness!==n}};var Oh=class{constructor(e,t){this.size_m=e;this.most_N=t;let n=e*.012;this.shaft=new ft(new Wi(n,n,1,12).translate(0,.5,0).rotateX(Math.PI/2),this.material),this.head=new ft(new Sa(n*3,n*8,16).rotateX(Math.PI/2),this.material),this.shaft.renderOrder=this.head.renderOrder=3,this.group.add(this.shaft,this.head),this.group.visible=!1}group=new Ct;shaft;head;material=new An({depthTest:!1,depthWrite:!1,transparent:!0,opacity:.9});grip;set colour(e){this.material.color.setHex(e)}show(e,[t,n]){let s=Math.hypot(t,n),r=this.size_m*(.12+.88*s/this.most_N);this.shaft.scale.z=r,this.head.position.z=r,this.group.quaternion.setFromUnitVectors(new O(0,0,1),new O(t,n,0).normalize()),this.group.visible=!0,this.grip=e,this.follow()}hide(){this.group.visible=!1,this.grip=void 0}follow(){this.grip&&(this.grip.group.updateWorldMatrix(!0,!1),this.group.position.copy(this.grip.place).applyMatrix4(this.grip.group.matrixWorld))}};var Bh=class extends mr{constructor(e){super(e)}load(e,t,n,s){let r=this,o=new Na(this.manager);o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},n,s)}parse(e){function t(c){let h=new DataView(c),u=32/8*3+32/8*3*3+16/8,d=h.getUint32(80,!0);if(80+32/8+d*u===h.byteLength)return!0;let g=[115,111,108,105,100];for(let v=0;v<5;v++)if(n(g,h,v))return!1;return!0}function n(c,h,u){for(let d=0,f=c.length;d<f;d++)if(c[d]!==h.getUint8(u+d))return!1;return!0}function s(c){let h=new DataView(c),u=h.getUint32(80,!0),d,f,g,v=!1,m,p,M,b,_;for(let C=0;C<70;C++)h.getUint32(C,!1)==1129270351&&h.getUint8(C+4)==82&&h.getUint8(C+5)==61&&(v=!0,m=new Float32Array(u*3*3),p=h.getUint8(C+6)/255,M=h.getUint8(C+7)/255,b=h.getUint8(C+8)/255,_=h.getUint8(C+9)/255);let I=84,R=50,D=new Vt,N=new Float32Array(u*3*3),T=new Float32Array(u*3*3),S=new Ke;for(let C=0;C<u;C++){let B=I+C*R,V=h.getFloat32(B,!0),$=h.getFloat32(B+4,!0),X=h.getFloat32(B+8,!0);if(v){let q=h.getUint16(B+48,!0);(q&32768)===0?(d=(q&31)/31,f=(q>>5&31)/31,g=(q>>10&31)/31):(d=p,f=M,g=b)}for(let q=1;q<=3;q++){let Q=B+q*12,Z=C*3*3+(q-1)*3;N[Z]=h.getFloat32(Q,!0),N[Z+1]=h.getFloat32(Q+4,!0),N[Z+2]=h.getFloat32(Q+8,!0),T[Z]=V,T[Z+1]=$,T[Z+2]=X,v&&(S.setRGB(d,f,g,Ht),m[Z]=S.r,m[Z+1]=S.g,m[Z+2]=S.b)}}return D.setAttribute("position",new on(N,3)),D.setAttribute("normal",new on(T,3)),v&&(D.setAttribute("color",new on(m,3)),D.hasColors=!0,D.alpha=_),D}function r(c){let h=new Vt,u=/solid([\s\S]*?)endsolid/g,d=/facet([\s\S]*?)endfacet/g,f=/solid\s(.+)/,g=0,v=/[\s]+([+-]?(?:\d*)(?:\.\d*)?(?:[eE][+-]?\d+)?)/.source,m=new RegExp("vertex"+v+v+v,"g"),p=new RegExp("normal"+v+v+v,"g"),M=[],b=[],_=[],I=new O,R,D=0,N=0,T=0;for(;(R=u.exec(c))!==null;){N=T;let S=R[0],C=(R=f.exec(S))!==null?R[1]:"";for(_.push(C);(R=d.exec(S))!==null;){let $=0,X=0,q=R[0];for(;(R=p.exec(q))!==null;)I.x=parseFloat(R[1]),I.y=parseFloat(R[2]),I.z=parseFloat(R[3]),X++;for(;(R=m.exec(q))!==null;)M.push(parseFloat(R[1]),parseFloat(R[2]),parseFloat(R[3])),b.push(I.x,I.y,I.z),$++,T++;X!==1&&console.error("THREE.STLLoader: Something isn't right with the normal of face number "+g),$!==3&&console.error("THREE.STLLoader: Something isn't right with the vertices of face number "+g),g++}let B=N,V=T-N;h.userData.groupNames=_,h.addGroup(B,V,D),D++}return h.setAttribute("position",new dt(M,3)),h.setAttribute("normal",new dt(b,3)),h}function o(c){return typeof c!="string"?new TextDecoder().decode(c):c}function a(c){if(typeof c=="string"){let h=new Uint8Array(c.length);for(let u=0;u<c.length;u++)h[u]=c.charCodeAt(u)&255;return h.buffer||h}else return c}let l=a(e);return t(l)?s(l):r(o(e))}};function ly(i,{place:e,turn:t}){i.position.fromArray(e),i.quaternion.fromArray(t)}function C1({kind:i,size:e}){return i==="sphere"?new Fs(e[0]/2,20,14):i==="cylinder"?new Wi(e[0]/2,e[0]/2,e[2],24).rotateX(Math.PI/2):new Vi(...e)}async function P1(i,e){let t=await fetch(i.mesh?.slice(1)??"",Qi(e));if(!t.ok)throw new Error(await t.text());let n=new Bh().parse(await t.arrayBuffer()),s=i.scale??[1,1,1],r=i.centre??[0,0,0];return n.scale(...s).translate(-r[0],-r[1],-r[2]),n.computeVertexNormals(),n}var Yi=class{constructor(e){this.description=e;this.links=e.links.map(()=>new Ct),this.base.add(this.links[0]??new Ct);for(let t of e.joints){let n=this.links[t.child];n&&(ly(n,t),this.links[t.parent]?.add(n),this.turning.push({group:n,rest:n.quaternion.clone(),axis:new O(...t.axis)}))}this.pose(e.joints.map(({home:t})=>t));for(let[t,{shapes:n}]of e.links.entries())for(let s of n)this.links[t]?.add(this.solid(s,C1(s)))}base=new Ct;links;turning=[];materials=new Map;spin=new en;async loadMeshes(e,t){let n=[];for(let[s,{shapes:r}]of this.description.links.entries())for(let[o,a]of r.entries()){let l=this.links[s]?.children.filter(c=>c instanceof ft)[o];!(l instanceof ft)||a.mesh===void 0||n.push(P1(a,e).then(c=>{l.geometry.dispose(),l.geometry=c,t()}))}await Promise.all(n)}pose(e){for(let[t,{group:n,rest:s,axis:r}]of this.turning.entries()){let o=e[t];o===void 0||Number.isNaN(o)||n.quaternion.copy(s).multiply(this.spin.setFromAxisAngle(r,o))}}gripAt(e){this.base.updateWorldMatrix(!1,!0);for(let{object:t,point:n}of e.intersectObject(this.base,!0)){let s=this.links.findIndex(o=>o===t.parent),r=this.links[s];if(r)return{link:s,group:r,place:r.worldToLocal(n.clone())}}}gripOn(e){let t=this.links[e],n=t?.children.find(s=>s instanceof ft);return t&&{link:e,group:t,place:n?.position.clone()??new O}}solePose(e){let{link:t,place:n,turn:s}=this.description.soles[e],r=new Tt().compose(new O(...n),new en(...s),new O(1,1,1)),o=this.links[t];return o?(o.updateWorldMatrix(!0,!1),r.premultiply(o.matrixWorld)):r}soleCorners(e){let{size:t,centre:n}=this.description.soles[e],s=this.solePose(e);return[[1,1],[-1,1],[-1,-1],[1,-1]].map(([o,a])=>new O(n[0]+o*t[0]/2,n[1]+a*t[1]/2,0).applyMatrix4(s))}setOld(e){for(let t of this.materials.values())t.transparent=e,t.opacity=e?.35:1,t.needsUpdate=!0}solid(e,t){let n=e.rgba.join(),s=this.materials.get(n);if(!s){let[o,a,l]=e.rgba;s=new us({color:new Ke().setRGB(o,a,l,Ht)}),this.materials.set(n,s)}let r=new ft(t,s);return ly(r,e),r}};var cy={light:{sky:15265266,ground:14541801,grid:12831958,made:9082790,planned:1533634,support:1804875,zmp:13708332,plannedZmp:1533634,com:11561472,push:8006614,twin:13902719,way:{left:888719,right:13920538,goal:1533634}},dark:{sky:1185565,ground:1514788,grid:2765629,made:6122362,planned:6533375,support:3523194,zmp:16739166,plannedZmp:6533375,com:16758605,push:12819455,twin:16740277,way:{left:3131072,right:16751181,goal:6533375}}};function I1(){return document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0})===null}function L1(i,e){let t=i.getContext("webgl2",{alpha:!1,antialias:e,stencil:!1,powerPreference:"low-power"});if(!t)throw new Error("this browser draws no WebGL 2");return t}var zh=class{constructor(e,t){this.canvas=e;this.size_m=t.hip_height*2,this.software=I1(),this.renderer=new Po({canvas:e,context:L1(e,!this.software)}),this.body=new Yi(t);let[n]=t.soles;this.ground=new Fh({length:n.size[0],width:n.size[1],ahead:n.centre[0]},this.size_m,cy.light),this.arrow=new Oh(this.size_m,t.bounds.push?.most??1),this.scene.fog=this.fog,this.scene.add(this.body.base,this.ground.group,this.arrow.group,new gr(16777215,8952234,2));let s=new yr(16777215,2.2);s.position.set(1.5,2,4),this.scene.add(s),this.camera.up.set(0,0,1),this.controls=new Nh(this.camera,e),this.controls.maxPolarAngle=Math.PI*.53,this.controls.minDistance=this.size_m*.6,this.controls.maxDistance=this.size_m*20,this.controls.addEventListener("change",()=>this.ask()),this.body.base.position.z=t.hip_height,this.followed.set(0,0,this.size_m*.56),this.lookFrom("behind"),new ResizeObserver(()=>this.resize()).observe(e);let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>this.paint(r.matches)),this.paint(r.matches)}body;pace=new Uh;software;renderer;scene=new hr;fog=new _a(0);camera=new xn(38,1,.02,200);controls;ground;arrow;size_m;followed=new O;pending=!0;old=!1;asked=!1;dark=!1;hazeAfter=6.5;follows=!0;onDrawn=()=>{};onBeforeDraw=()=>{};onPaint=()=>{};show(e){let[t=NaN,n=NaN]=e.base_place,s=e.base_height[0]??NaN;if(!Number.isNaN(t+n+s)){this.body.base.position.set(t,n,s);let[r=0,o=0,a=0,l=1]=e.base_turn;this.body.base.quaternion.set(r,o,a,l).normalize()}this.body.pose(e.joint),this.ground.show(e,this.body),this.arrow.follow(),this.follows&&this.follow(),this.pace.wish(),this.ask()}setOld(e){e!==this.old&&(this.old=e,this.body.setOld(e),this.ask())}lookFrom(e){let t=this.size_m*2.5,n={behind:[-.78*t,-.52*t,.42*t],front:[t,.15*t,.25*t],side:[0,-t,.2*t],top:[-.02*t,0,1.2*t]};this.controls.target.copy(this.followed),this.camera.position.copy(this.followed).add(new O(...n[e])),this.controls.update(),this.ask()}zoom(e){let t=this.camera.position.clone().sub(this.controls.target);t.setLength(Xa.clamp(t.length()*e,this.controls.minDistance,this.controls.maxDistance)),this.camera.position.copy(this.controls.target).add(t),this.controls.update(),this.ask()}gripAt(e,t){return this.body.gripAt(this.rayAt(e,t))}rayAt(e,t){let{left:n,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new Oa;return a.setFromCamera(new we(2*(e-n)/r-1,1-2*(t-s)/o),this.camera),a}add(e){this.scene.add(e),this.ask()}showWorld(){this.ground.hideGrid(),this.ask()}forgetSteps(){this.ground.forgetSteps(),this.ask()}turnBySecond(e){this.controls.mouseButtons.RIGHT=e?Ei.ROTATE:Ei.PAN,this.controls.touches.TWO=e?Ai.DOLLY_ROTATE:Ai.DOLLY_PAN}repaint(){this.paint(this.dark)}gripOn(e){return this.body.gripOn(e)}away(){let e=this.camera.getWorldDirection(new O);Math.hypot(e.x,e.y)<.2&&e.set(0,1,0).applyQuaternion(this.camera.quaternion);let t=Math.hypot(e.x,e.y);return[e.x/t,e.y/t]}showPush(e,t){this.arrow.show(e,t),this.ask()}hidePush(){this.arrow.hide(),this.ask()}ask(){this.pending=!0,!(this.asked||document.hidden)&&(this.asked=!0,requestAnimationFrame(e=>this.draw(e)))}draw(e){if(this.asked=!1,!!this.pending){if(!this.pace.isDue(e)){this.ask();return}this.pending=!1,this.haze(),this.onBeforeDraw(e,this.camera,this.fog.far),this.renderer.render(this.scene,this.camera),this.pace.drew(e)&&this.resize(),this.onDrawn()}}haze(){let e=this.camera.position.distanceTo(this.controls.target);this.fog.near=e+this.size_m,this.fog.far=e+Math.max(this.hazeAfter*this.size_m,e)}follow(){let{x:e,y:t}=this.body.base.position,n=new O(e-this.followed.x,t-this.followed.y,0);this.followed.add(n),this.controls.target.add(n),this.camera.position.add(n),this.camera.updateMatrixWorld()}paint(e){this.dark=e;let t=cy[e?"dark":"light"];this.scene.background=new Ke(t.sky),this.fog.color.set(t.sky),this.ground.setColours(t),this.arrow.colour=t.push,this.onPaint(t,e),this.ask()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setPixelRatio(Math.min(devicePixelRatio,this.software?1:2)*this.pace.fineness),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.ask())}};var tp={name:"/simulation/state",type:"gaitway_msgs/msg/SimulationState"},np=1e3,k1=["command","push","fault","world","fall"],hy=["playing","paused","busy","failed"],Za=i=>Array.isArray(i)?i:[],Hh=i=>Za(i).map(Number);function ip(i){let{position:e,orientation:t}=i;return{place:[e.x,e.y,e.z],turn:[t.x,t.y,t.z,t.w]}}function uy(i){let e=Za(i.mark_kinds),t=Za(i.event_texts),n=Za(i.thing_poses),s=Hh(i.odometry),r=Hh(i.base),o=String(i.state);return{time_s:Number(i.time),recorded_s:Math.max(Number(i.recorded),Number(i.time)),state:hy.includes(o)?o:"failed",text:hy.includes(o)?String(i.text??""):`it says that it is '${o}', which this page does not know`,speed:Number(i.speed),pace:Number(i.pace),world:String(i.world??""),geometry:Number(i.geometry),run:Number(i.run),fallen:i.fallen===!0,odometry:s.length===4&&s.every(Number.isFinite)?{x:s[0],y:s[1],z:s[2],yaw:s[3]}:void 0,base:r.length===7?{place:r.slice(0,3),turn:r.slice(3)}:void 0,things:new Map(Za(i.thing_names).flatMap((a,l)=>n[l]?[[String(a),ip(n[l])]]:[])),marks:Hh(i.mark_times).flatMap((a,l)=>k1.includes(String(e[l]))?[{at_s:a,kind:e[l]}]:[]),events:Hh(i.event_times).map((a,l)=>({at_s:a,text:String(t[l]??"")}))}}function dy({state:i,speed:e}){return i==="playing"?e:0}var fy=i=>[Number(i[0]),Number(i[1]),Number(i[2])];function vy(i){let e=i.solids.map(t=>{let n=t.size,s=String(t.shape);if(s!=="box"&&s!=="cylinder"&&s!=="sphere")throw new Error(`solid '${String(t.name)}' has the shape '${s}': box, cylinder or sphere is known`);return{...ip(t.pose),name:String(t.name),kind:String(t.kind),shape:s,size:[n.x,n.y,n.z],colour:fy(t.colour),movable:t.movable===!0}});return{geometry:Number(i.geometry),world:String(i.world),total:Number(i.total),floorColour:fy(i.floor_colour),solids:e}}function Ka({kind:i}){return i==="step"||i==="slope"||i==="tile"}function py([i,e,t,n],[s,r,o]){let[a,l,c]=[2*(t*r-e*o),2*(i*o-t*s),2*(e*s-i*r)];return[s+n*a-(e*c-t*l),r+n*l-(t*a-i*c),o+n*c-(i*l-e*a)]}function my([i,e,t],n,s){let[r,o]=[-1/0,1/0];for(let[a,l]of[i,e,t].entries()){let c=s[a]/2,h=n[a];if(Math.abs(h)<1e-12){if(Math.abs(l)>c)return;continue}let[u,d]=[(-c-l)/h,(c-l)/h];r=Math.max(r,Math.min(u,d)),o=Math.min(o,Math.max(u,d))}return r<=o&&o>=0?Math.max(r,0):void 0}function gy(i,e,t){let n=e.reduce((a,l)=>a+l*l,0),s=e.reduce((a,l,c)=>a+l*i[c],0),r=i.reduce((a,l)=>a+l*l,-t*t);if(n<1e-12)return r<=0?[-1/0,1/0]:void 0;let o=s*s-n*r;return o<0?void 0:[(-s-Math.sqrt(o))/n,(-s+Math.sqrt(o))/n]}function _y(i,{origin:e,direction:t},n=i){let{place:s}=n,r=py(n.turn,[e[0]-s[0],e[1]-s[1],e[2]-s[2]]),o=py(n.turn,t);if(i.shape==="box")return my(r,o,i.size);let a=i.shape==="sphere"?gy(r,o,i.size[0]/2):gy(r.slice(0,2),o.slice(0,2),i.size[0]/2);if(!a)return;let[l,c]=a;if(i.shape==="cylinder"){if(my([0,0,r[2]],[0,0,o[2]],[1,1,i.size[2]])===void 0)return;if(Math.abs(o[2])>1e-12){let u=i.size[2]/2,d=[(-u-r[2])/o[2],(u-r[2])/o[2]];l=Math.max(l,Math.min(...d)),c=Math.min(c,Math.max(...d))}}return l<=c&&c>=0?Math.max(l,0):void 0}var D1=({origin:i,direction:e},t)=>[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]];function xy(i,e,t=n=>n){let n,s=(r,o)=>{r===void 0||r>=(n?.distance_m??1/0)||(n={distance_m:r,place:D1(i,r),solid:o})};i.direction[2]<-1e-6&&i.origin[2]>0&&s(-i.origin[2]/i.direction[2],void 0);for(let r of e)s(_y(r,i,t(r)),r);return n}var yy=50;function by(i,e,t){let n=0;for(let s of i){if(!Ka(s))continue;let r=_y(s,{origin:[e,t,yy],direction:[0,0,-1]});r!==void 0&&(n=Math.max(n,yy-r))}return n}var Ar=i=>Math.atan2(Math.sin(i),Math.cos(i));function wy({x:i,y:e,z:t,yaw:n}){let[s,r]=[Math.cos(n),Math.sin(n)];return{x:-(s*i+r*e),y:-(s*e-r*i),z:-t,yaw:-n}}function sp({x:i,y:e,z:t,yaw:n},s){let[r,o]=[Math.cos(n),Math.sin(n)];return{x:i+r*s.x-o*s.y,y:e+o*s.x+r*s.y,z:t+s.z}}var Vh=class{wanted;shown;run;get isKnown(){return this.shown!==void 0}take(e,t){if(!e)return!1;let{shown:n}=this,s=!n||t!==this.run||Math.hypot(e.x-n.x,e.y-n.y,e.z-n.z)>.25||Math.abs(Ar(e.yaw-n.yaw))>.35;return this.wanted=e,this.run=t,s&&(this.shown={...e}),s}after(e){let{wanted:t,shown:n}=this;if(!t||!n)return;let s=1-Math.exp(-Math.max(e,0)/.25);return n.x+=s*(t.x-n.x),n.y+=s*(t.y-n.y),n.z+=s*(t.z-n.z),n.yaw+=s*Ar(t.yaw-n.yaw),n}};var My=.006,N1=.28;function F1(i,e,t){let[n,s,r]=[i/2,e/2,N1*e],o=new hs().moveTo(-n+r,-s).lineTo(n-r,-s).quadraticCurveTo(n,-s,n,-s+r).lineTo(n,s-r).quadraticCurveTo(n,s,n-r,s).lineTo(-n+r,s).quadraticCurveTo(-n,s,-n,s-r).lineTo(-n,-s+r).quadraticCurveTo(-n,-s,-n+r,-s);return new Ns(o,4).translate(t,0,0)}function ja(i,e){return new An({color:i,transparent:!0,opacity:e,depthWrite:!1,side:hi,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-4})}var Gh=class{group=new Ct;sole;coming;passed;goalMaterial;goal=new Ct;soles=[];sides=[];constructor(e,t,n){this.sole=F1(e.length,e.width,e.ahead),this.coming=[ja(n.left,.85),ja(n.right,.85)],this.passed=[ja(n.left,.16),ja(n.right,.16)],this.goalMaterial=ja(n.goal,.9);let s=t*.24,r=new ft(new ka(s*.86,s,48),this.goalMaterial),o=new hs().moveTo(s*1.75,0).lineTo(s*1.12,s*.42).lineTo(s*1.12,-s*.42);this.goal.add(r,new ft(new Ns(o),this.goalMaterial)),this.goal.visible=!1,this.group.add(this.goal)}setColours({left:e,right:t,goal:n}){for(let s of[this.coming,this.passed])s[0].color.setHex(e),s[1].color.setHex(t);this.goalMaterial.color.setHex(n)}showGoal({x:e,y:t,yaw:n},s){this.goal.position.set(e,t,s(e,t)+My),this.goal.rotation.z=n,this.goal.visible=!0}showPlan(e,t){this.clearSteps(),this.sides=e.steps.map(({side:n})=>n);for(let{x:n,y:s,yaw:r,side:o}of e.steps){let a=new ft(this.sole,this.coming[o]);a.position.set(n,s,t(n,s)+My),a.rotation.z=r,this.soles.push(a),this.group.add(a)}}fade(e){for(let[t,n]of this.soles.entries())n.material=(t<e?this.passed:this.coming)[this.sides[t]??0]}clearSteps(){for(let e of this.soles.splice(0))this.group.remove(e)}clear(){this.clearSteps(),this.goal.visible=!1}};var U1=8368874;function rp(i,e=1){i.base.traverse(t=>{if(!(t instanceof ft))return;let n=t.material;n.color.set(U1),n.transparent=e<1,n.opacity=e,n.depthWrite=e===1})}var Wh=class{group=new Ct;body;constructor(e){this.body=new Yi(e),rp(this.body,.42),this.body.base.updateMatrixWorld(!0);let t=[0,1].map(s=>new O().setFromMatrixPosition(this.body.solePose(s))),n=t[0].add(t[1]).multiplyScalar(.5);this.body.base.position.sub(n),this.group.add(this.body.base),this.group.visible=!1}show(e,t,n,s){this.group.position.set(e,t,n),this.group.rotation.z=s,this.group.visible=!0}hide(){this.group.visible=!1}};var O1={box:()=>new Vi(1,1,1),cylinder:i=>new Wi(.5,.5,1,i?24:8).rotateX(Math.PI/2),sphere:i=>i?new Fs(.5,20,14):new Fs(.5,8,5)},Sy=new Map;function $h(i,e){let t=`${i} ${e}`,n=Sy.get(t)??O1[i](e);return Sy.set(t,n),n}var Ty=3,B1=300,z1=new O(1.5,2,4).normalize(),H1=2.2,V1=2,op=new Ke(8952234);function G1(i,e){let t=.5+.5*i.z,n=H1*Math.max(i.dot(z1),0),s=r=>(n+V1*(r+(1-r)*t))/Math.PI;return e.setRGB(s(op.r),s(op.g),s(op.b))}var ap=class{positions=[];colours=[];indices=[];matrix=new Tt;turn=new en;point=new O;lit=new Ke;paint=new Ke;add(e,t){let n=$h(e.shape,t),[s,r]=[n.getAttribute("position"),n.getAttribute("normal")],o=this.positions.length/3,a=new O(...e.size);this.matrix.compose(this.point.fromArray(e.place),this.turn.fromArray(e.turn),a),this.paint.setRGB(...e.colour,Ht);for(let l=0;l<s.count;++l){this.point.fromBufferAttribute(s,l).applyMatrix4(this.matrix),this.positions.push(this.point.x,this.point.y,this.point.z);let{r:c,g:h,b:u}=G1(this.point.fromBufferAttribute(r,l).divide(a).normalize().applyQuaternion(this.turn),this.lit).multiply(this.paint);this.colours.push(c,h,u)}for(let l of n.index?.array??[])this.indices.push(o+l)}mesh(e){let t=new Vt;return t.setAttribute("position",new dt(this.positions,3)),t.setAttribute("color",new dt(this.colours,3)),t.setIndex(this.indices),t.computeBoundingSphere(),new ft(t,e)}},Xh=class{group=new Ct;material=new An({vertexColors:!0});set brightness(e){this.material.color.setScalar(e)}show(e){for(let n of this.group.children.splice(0))n.geometry.dispose();let t=new Map;for(let n of e){let s=`${Math.floor(n.place[0]/Ty)} ${Math.floor(n.place[1]/Ty)}`,r=t.get(s)??new ap;t.set(s,r),r.add(n,e.length<=B1)}for(let n of t.values())this.group.add(n.mesh(this.material))}see(e,t){for(let n of this.group.children){let s=n.geometry.boundingSphere;n.visible=!s||e.distanceTo(s.center)-s.radius<t}}};var W1=.08,$1=1e-4,X1=1e-7,qh=class{group=new Ct;things=new Map;held;brightness=1;show(e){let t=new Map([...this.things].map(([n])=>[n,this.poseOf(n)]));for(let{mesh:n}of this.things.values())n.material.dispose();this.things.clear(),this.group.clear();for(let n of e)this.add(n,t.get(n.name)??n);this.held&&this.group.add(this.held.mesh)}setBrightness(e){this.brightness=e;for(let{mesh:t,solid:n}of this.things.values())this.paint(t,n)}poseOf(e){let t=this.held?.solid.name===e?this.held:this.things.get(e);return t&&{place:t.mesh.position.toArray(),turn:t.mesh.quaternion.toArray()}}move(e,t){for(let[n,s]of e){let r=this.things.get(n);!r||r===this.held||(r.wanted=s,t&&this.follow(r,s,1))}}after(e){let t=1-Math.exp(-e/W1);for(let n of this.things.values())n.wanted&&n!==this.held&&this.follow(n,n.wanted,t)}hold(e,{place:t,turn:n}){this.held??=this.things.get(e.name)??this.make(e,e),this.held.mesh.position.set(...t),this.held.mesh.quaternion.set(...n),this.held.mesh.parent||this.group.add(this.held.mesh)}letGo(){let{held:e}=this;this.held=void 0,e&&this.things.get(e.solid.name)!==e&&this.group.remove(e.mesh)}add(e,t){let n=this.make(e,t);this.things.set(e.name,n),this.group.add(n.mesh)}make(e,{place:t,turn:n}){let s=new ft($h(e.shape,!0),new us);return this.paint(s,e),s.scale.set(...e.size),s.position.set(...t),s.quaternion.set(...n),{mesh:s,solid:e,wanted:void 0}}paint(e,{colour:t}){e.material.color.setRGB(...t,Ht).multiplyScalar(this.brightness)}follow(e,{place:t,turn:n},s){let{position:r,quaternion:o}=e.mesh,[a,l]=[new O(...t),new en(...n)];r.lerp(a,s),o.slerp(l,s),!(r.distanceTo(a)>$1||Math.abs(o.dot(l))<1-X1)&&(r.copy(a),o.copy(l),e.wanted=void 0)}};var Ey=40,q1={half_m:8,every_m:.5,piece_m:2},Ay=.72,Yh=class{group=new Ct;things=new qh;fixed=new Xh;floorMaterial=new An({depthWrite:!1});lineMaterial=new Gi({depthWrite:!1});ground=new Ct;floorColour=new Ke(.75,.75,.75);dark=!1;all=[];constructor(){let e=new ft(new fr(2*Ey,2*Ey),this.floorMaterial),t=this.makeGrid();e.renderOrder=-2,t.renderOrder=-1,this.ground.add(e,t),this.group.add(this.ground,this.fixed.group,this.things.group),this.group.visible=!1}get solids(){return this.all}poseOf(e){return this.things.poseOf(e.name)??e}setSolids(e,t){this.all=e,this.fixed.show(e.filter(({movable:n})=>!n)),this.things.show(e.filter(({movable:n})=>n)),this.floorColour.setRGB(...t,Ht),this.group.visible=!0,this.setDark(this.dark)}setDark(e){this.dark=e;let t=this.floorColour.getHSL({h:0,s:0,l:0},Ht),{h:n,s,l:r}=t.s<.05?{h:.58,s:e?.16:.1,l:t.l}:t,o=e?.09+.1*r:.72+.16*r;this.floorMaterial.color.setHSL(n,Math.min(s,.35),o,Ht),this.lineMaterial.color.setHSL(n,Math.min(s,.35),o+(e?.09:-.07),Ht),this.fixed.brightness=e?Ay:1,this.things.setBrightness(e?Ay:1)}put(e,t){let{x:n,y:s,z:r,yaw:o}=wy(e);this.group.position.set(n,s,r),this.group.rotation.z=o,this.group.updateMatrixWorld(),this.things.after(t)}centreOn(e,t){this.ground.position.set(Math.round(e),Math.round(t),0)}see(e,t){this.fixed.see(this.group.worldToLocal(e.position.clone()),t)}makeGrid(){let{half_m:e,every_m:t,piece_m:n}=q1,s=[];for(let r=-e;r<=e;r+=t)for(let o=-e;o<e;o+=n)s.push(o,r,0,o+n,r,0,r,o,0,r,o+n,0);return new _o(new Vt().setAttribute("position",new dt(s,3)),this.lineMaterial)}};var Y1=300,Z1=.5,Zh=class{constructor(e,t,n){this.scene=e;let[s]=t.soles;this.marks=new Gh({length:s.size[0],width:s.size[1],ahead:s.centre[0]},e.size_m,{left:0,right:0,goal:0}),this.ghost=new Wh(t),this.world.group.add(this.marks.group,this.ghost.group),e.onBeforeDraw=(r,o,a)=>{this.settle(r),this.world.see(o,a)},e.onPaint=({way:r,twin:o},a)=>{this.marks.setColours(r),this.twin?.setColour(o),this.world.setDark(a)},e.add(this.world.group),e.showWorld(),e.repaint(),this.ghost.body.loadMeshes(n,()=>e.ask()).catch(()=>{})}world=new Yh;frame=new Vh;marks;ghost;odometry={x:0,y:0,z:0,yaw:0};run;twin;drawn_ms=0;ask(){this.scene.ask()}addTwin(e){this.twin=e,this.world.group.add(e.group),this.scene.repaint()}setSolids(e,t){this.world.setSolids(e,t),this.scene.hazeAfter=e.length>Y1?9:11,this.scene.ask()}show(e,t){this.frame.take(t??(this.frame.isKnown?void 0:e.odometry),e.run)&&this.scene.forgetSteps(),this.world.things.move(e.things,e.run!==this.run),this.run=e.run,this.scene.ask()}hitAt(e,t){if(!this.scene.gripAt(e,t))return xy(this.rayAt(e,t),this.world.solids,n=>this.world.poseOf(n))}levelAt(e,t,n){let{origin:s,direction:r}=this.rayAt(e,t),o=(n-s[2])/r[2];if(o>0&&o<100)return[s[0]+o*r[0],s[1]+o*r[1],n]}robotPlace(){let{position:e,quaternion:{x:t,y:n,z:s,w:r}}=this.scene.body.base,o=sp(this.odometry,e);return{x:o.x,y:o.y,yaw:this.odometry.yaw+Math.atan2(2*(t*n+r*s),1-2*(n*n+s*s))}}showGoal(e){this.marks.showGoal(e,this.height),this.ghost.show(e.x,e.y,this.height(e.x,e.y),e.yaw),this.scene.ask()}showPlan(e){e?this.marks.showPlan(e,this.height):this.marks.clearSteps(),this.scene.ask()}fadeSteps(e){this.marks.fade(e),this.scene.ask()}clearWay(){this.marks.clear(),this.ghost.hide(),this.scene.ask()}height=(e,t)=>by(this.world.solids,e,t);rayAt(e,t){let{ray:n}=this.scene.rayAt(e,t);return n.applyMatrix4(this.world.group.matrixWorld.clone().invert()),{origin:n.origin.toArray(),direction:n.direction.toArray()}}settle(e){let t=Math.min((e-this.drawn_ms)/1e3,Z1);this.drawn_ms=e,this.odometry=this.frame.after(t)??this.odometry,this.world.put(this.odometry,t);let{x:n,y:s}=sp(this.odometry,this.scene.body.base.position);this.world.centreOn(n,s),this.twin?.settle(e)&&this.scene.ask()}};var Rr=(i,e=600,t=.001)=>({kind:"number",key:"duration_s",name:"for",unit:"s",value:i,least:t,most:e}),Kh=(i,e,t)=>({kind:"number",key:i,name:e,unit:"%",value:t,least:0,most:100}),Ry=[{fault:"lose_frames",title:"Frames are lost",text:"Each frame on the bus is lost with this probability.",fields:[Kh("probability","lost",2),Rr(2)]},{fault:"disturb_bus",title:"The bus is disturbed",text:"Attempts to send a frame meet errors; the bus repeats them.",fields:[Kh("corruption","corrupted",1),Kh("omission","left out",.1),Kh("duplicate","doubled",.1),Rr(10)]},{fault:"jam",title:"The bus is jammed",text:"Nobody can send for so long.",fields:[Rr(.002,10,1e-5),{kind:"choice",key:"stuck",name:"by",of:[{value:"",text:"noise"},{value:"true",text:"a line that is stuck"}]}]},{fault:"bus_off",title:"A station is bus-off",text:"Its frames are destroyed until it leaves the bus; it comes back as the standard has it.",fields:[{kind:"choice",key:"node",name:"station",of:"nodes"}]},{fault:"joint_restarts",title:"A joint restarts",text:"Its controller is without power for a while, its motor without torque.",fields:[{kind:"choice",key:"joint",name:"joint",of:"joints"},Rr(.02,60)]},{fault:"main_controller_silent",title:"Main controller silent",text:"It makes no tick for so long: the message controller plays the safe tail.",fields:[Rr(1)]},{fault:"plugin_fails",title:"A plug-in fails",text:"Its steps fail for so long; the manager falls back on what it has. One that fails too often is out of service until it is reloaded (view Plug-ins).",fields:[{kind:"choice",key:"plugin",name:"plug-in",of:"plugins"},{kind:"choice",key:"how",name:"it",of:[{value:"throws",text:"throws"},{value:"not_a_number",text:"gives no numbers"},{value:"jumps",text:"gives nonsense"},{value:"overruns",text:"takes too long"}]},Rr(1)]},{fault:"sensor_fails",title:"A sensor fails",text:"It tells something else than what is; of a joint, its encoder.",fields:[{kind:"choice",key:"sensor",name:"sensor",of:"sensors"},{kind:"choice",key:"how",name:"it",of:[{value:"freezes",text:"freezes"},{value:"reads_zero",text:"reads zero"},{value:"noisy",text:"is noisy"}]},Rr(.5)]}];function Cy(i,e){let t={kind:i.fault};for(let n of i.fields){let s=(e.get(n.key)??"").trim();if(n.kind==="choice"){if(s===""&&typeof n.of=="string")throw new Error(`${i.title}: no ${n.name} is chosen`);s!==""&&(t[n.key]=s==="true"?!0:s);continue}let r=Number(s);if(s===""||!(r>=n.least&&r<=n.most))throw new Error(`${i.title}: “${n.name}” is '${s}', and must be ${n.least} … ${n.most} ${n.unit}`);t[n.key]=n.unit==="%"?Number((r/100).toPrecision(12)):r}return{fault:t}}function K1(i,e){return(typeof i.of=="string"?e[i.of].map(n=>({value:n,text:n.replaceAll("_"," ")})):i.of).map(({value:n,text:s})=>A("option",{value:n},s))}function j1(i,e,t){let n=`fault-${i.fault}-${e.key}`;if(e.kind==="choice"){let r=A("select",{id:n},...K1(e,t));return{label:A("label",{for:n},e.name,r),input:r}}let s=A("input",{id:n,type:"number",step:"any",min:e.least,max:e.most,value:e.value});return{label:A("label",{for:n},e.name,s,e.unit),input:s}}function Py({attempt:i,description:e,robot:t},n){let s=e.joints.map(({name:h})=>h),r={joints:s,nodes:["message_controller",...s],plugins:[],sensors:["imu","left_foot","right_foot",...s]},o,a=Ry.map(h=>{let u=h.fields.map(f=>({field:f,...j1(h,f,r)}));for(let{field:f,input:g}of u)f.kind==="choice"&&f.of==="plugins"&&(o=g);let d=A("form",{class:"card fault",id:`fault-${h.fault}`,novalidate:!0},A("header",{},A("h2",{},h.title),A("button",{type:"submit","aria-label":`${h.title}: now`},"Now")),A("p",{class:"note"},h.text),A("div",{class:"fields"},...u.map(({label:f})=>f)));return d.addEventListener("submit",f=>{f.preventDefault(),i(h.title,()=>n.apply(Cy(h,new Map(u.map(({field:g,input:v})=>[g.key,v.value])))),"applied")}),d}),l=A("p",{class:"note",role:"status"}),c=async()=>{let{plugins:h}=await t.order("/plugins/list"),u=o?.value;o?.replaceChildren(...h.filter(({name:d})=>d!=="api").map(({name:d})=>A("option",{value:d,selected:d===u},d)))};return{title:"Faults",content:A("div",{class:"faults"},A("p",{class:"hint"},"What goes wrong with the simulated robot, from now on. The time line keeps a mark of it: drag back to before, and it never was."),...a,l),show:()=>void c().then(()=>he(l,""),h=>he(l,`The plug-ins are not known: ${h.message}`))}}var jh=i=>Math.round(i*1e3)/1e3+0;function lp(i,[e,t,n]){return i==="sphere"?[e,e,e]:i==="cylinder"?[e,e,n]:[e,t,n]}function J1(i){let e=/^#[0-9a-f]{6}$/i.test(i)?parseInt(i.slice(1),16):8421504;return[e>>16,e>>8&255,e&255].map(t=>Math.round(t/255*1e3)/1e3)}function Ny(i,e){for(let t=1;;++t){let n=t===1?i:`${i}_${t}`;if(!e.has(n))return n}}function Fy(i,e,t,n=0){let s=lp(i.shape,i.size),r=i.mass_kg===void 0?{}:{mass_kg:i.mass_kg};return{spawn:{name:e,shape:i.shape,size_m:s,position_m:[jh(t[0]),jh(t[1]),jh(t[2]+s[2]/2)],yaw_deg:n,...r,colour:J1(i.colour)}}}function Uy(i,e,t){return{move:{name:i,position_m:e.map(jh),yaw_deg:Math.round(t*1800/Math.PI)/10+0}}}function Oy(i){return{remove:{name:i}}}function Ja({kind:i,movable:e}){return e||i==="thing"||i==="box"}var Iy=.01,Ly=5,ky=.001,Dy=1e3;function By({size:i,mass_kg:e}){for(let[t,n]of i.entries())if(!(n>=Iy&&n<=Ly))throw new Error(`${["length","width","height"][t]} is ${n} m, and must be ${Iy} … ${Ly} m`);if(e!==void 0&&!(e>=ky&&e<=Dy))throw new Error(`mass is ${e} kg, and must be ${ky} … ${Dy} kg`)}var Q1=300,eA=.01,Jh=class{constructor(e,t,n,s){this.picture=e;this.canvas=t;this.tools=n;this.user=s;t.after(this.label);let r=(o,a)=>t.addEventListener(o,a,{capture:!0});r("pointerdown",o=>this.begin(o)),r("pointermove",o=>this.move(o)),r("pointerup",o=>void this.end(o)),r("pointercancel",()=>this.cancel()),t.addEventListener("pointerleave",()=>this.label.hidden=!this.drag),window.addEventListener("keydown",o=>o.key==="Escape"&&this.cancel(),{capture:!0})}on=!1;places=!1;label=A("p",{class:"push-label",hidden:!0});drag;onToggle=()=>{};setOn(e){e!==this.on&&(this.on=e,e?this.tools.choose(this):(this.cancel(),this.label.hidden=!0,this.places=!1),this.canvas.classList.toggle("places",e),this.onToggle(e))}cancel(){let{drag:e}=this;this.drag=void 0,e&&(this.putBack(e),this.label.hidden=!0)}begin(e){if(this.drag){this.cancel();return}let t=this.on&&e.button===0?this.picture.hitAt(e.clientX,e.clientY):void 0;if(!t)return;let n=t.solid&&Ja(t.solid)?t.solid:void 0;if(!n){if(!this.places)return;e.stopImmediatePropagation(),this.user.place(t.place);return}e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId),this.letGo();let s=this.picture.world.poseOf(n);this.drag={pointer:e.pointerId,solid:n,pose:s,grip:t.place,at:s.place,moved:!1},this.user.choose(n)}move(e){let{drag:t}=this;if(t||this.tellThing(e),!t||e.pointerId!==t.pointer)return;e.stopImmediatePropagation();let n=this.picture.levelAt(e.clientX,e.clientY,t.grip[2]);if(!n)return;let[s,r]=[n[0]-t.grip[0],n[1]-t.grip[1]];t.moved||=Math.hypot(s,r)>eA,t.moved&&(t.at=[t.pose.place[0]+s,t.pose.place[1]+r,t.pose.place[2]],this.picture.world.things.hold(t.solid,{place:t.at,turn:t.pose.turn}),this.picture.ask(),this.tell(e,`${t.solid.name}: x ${t.at[0].toFixed(2)} m, y ${t.at[1].toFixed(2)} m`))}async end(e){let{drag:t}=this;if(!t||e.pointerId!==t.pointer||(e.stopImmediatePropagation(),this.drag=void 0,this.label.hidden=!0,!t.moved))return;await this.user.move(t.solid,t.at,er(t.pose.turn))?setTimeout(()=>!this.drag&&this.letGo(),Q1):this.putBack(t)}putBack({solid:e,moved:t,pose:n}){t&&(this.picture.world.things.hold(e,n),this.letGo())}letGo(){this.picture.world.things.letGo(),this.picture.ask()}tellThing(e){let t=this.on&&e.buttons===0&&e.pointerType==="mouse"?this.picture.hitAt(e.clientX,e.clientY):void 0,n=t?.solid&&Ja(t.solid)?t.solid:void 0;this.label.hidden=!n&&!(t&&this.places),n?this.tell(e,`${n.name}: drag to move`):t&&this.places&&this.tell(e,"Put it here")}tell(e,t){he(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}};var zy=[{shape:"box",text:"Box",size:[.2,.2,.1],measures:["length","width","height"]},{shape:"cylinder",text:"Cylinder",size:[.15,.15,.2],measures:["diameter","","height"]},{shape:"sphere",text:"Ball",size:[.15,.15,.15],measures:["diameter","",""]}],cp=class{box;shape="box";measures=[0,1,2].map(e=>A("input",{type:"number",id:`thing-size-${e}`,min:1,max:500,step:"any"}));labels=this.measures.map(e=>{let t=A("span");return{name:t,label:A("label",{},t,e,"cm")}});fast=A("input",{type:"checkbox",id:"thing-fast"});mass=A("input",{type:"number",id:"thing-mass",min:.001,step:"any",value:.5});colour=A("input",{type:"color",id:"thing-colour",value:"#e08a2b"});buttons;constructor(){this.buttons=zy.map(({shape:e,text:t})=>ke(t,()=>this.choose(e),{"aria-pressed":"false",id:`thing-${e}`})),this.fast.addEventListener("change",()=>this.mass.disabled=this.fast.checked),this.box=A("div",{class:"thing-form"},A("div",{class:"buttons",role:"group","aria-label":"Shape"},...this.buttons),A("div",{class:"fields"},...this.labels.map(({label:e})=>e),A("label",{},"mass",this.mass,"kg"),A("label",{class:"check"},this.fast,"stands fast"),A("label",{},"colour",this.colour))),this.choose("box")}get thing(){let e=this.measures.map(n=>Number(n.value)/100),t={shape:this.shape,size:lp(this.shape,e),mass_kg:this.fast.checked?void 0:Number(this.mass.value),colour:this.colour.value};return By(t),t}choose(e){this.shape=e;for(let[t,n]of zy.entries())if(this.buttons[t].setAttribute("aria-pressed",String(n.shape===e)),n.shape===e)for(let[s,{name:r,label:o}]of this.labels.entries())he(r,n.measures[s]),o.hidden=n.measures[s]==="",this.measures[s].value=String(Math.round(n.size[s]*1e3)/10)}};function Hy({attempt:i,news:e},t,n,s,r){let o=new cp,a=A("ul",{class:"things","aria-label":"Things that can be moved"}),l=A("p",{class:"hint",role:"status"}),c,h=!1,u=b=>{try{let{thing:_}=o,I=Ny(_.shape,new Set(n.world.solids.map(R=>R.name)));i(`New ${I}`,()=>t.apply(Fy(_,I,b)))}catch(_){e.say(`It was not put there: ${_.message}`,"bad","thing")}},d=b=>void i(`Take ${b} away`,()=>t.apply(Oy(b))),f=(b,_,I)=>i(`Move ${b.name}`,()=>t.apply(Uy(b.name,_,I))),g=b=>{c=b?.name,M(),a.querySelector("[aria-current]")?.scrollIntoView({block:"nearest"})},v=new Jh(n,s,r,{place:u,choose:g,move:f}),m=ke("Put it where I click",()=>{let b=!(v.on&&v.places);v.setOn(!0),v.places=b,p()},{id:"thing-put",class:"primary","aria-pressed":"false"}),p=()=>{let b=v.on&&v.places;m.setAttribute("aria-pressed",String(b)),he(m,b?"Click a place in the picture":"Put it where I click"),he(l,a.childElementCount===0?"Nothing here can be moved yet.":"Drag a thing in the picture to move it.")},M=()=>{let b=n.world.solids.filter(_=>!Ka(_)&&Ja(_)&&(_.movable||_.kind==="thing"||_.name===c));a.replaceChildren(...b.map(_=>A("li",_.name===c?{"aria-current":"true"}:{},A("span",{},_.name),ke("Take away",()=>d(_.name),{"aria-label":`Take ${_.name} away`})))),p()};return v.onToggle=p,{title:"Things",tool:v,content:A("div",{class:"things-tab"},A("h2",{},"A new thing"),o.box,m,A("h2",{},"What can be moved"),l,a),show:()=>{h=!0,v.setOn(!0),M()},hide:()=>{h=!1,r.done(v)},worldChanged:()=>h&&M()}}function tA(i){return typeof i=="string"?[...atob(i)].map(e=>e.charCodeAt(0)):Array.isArray(i)?i.map(Number):[]}function Gy(i){let e=tA(i.sides),t=i.steps.map(Number),n=i.feet.map(Number);if(t.length!==3*e.length||n.length!==6||![...t,...n].every(Number.isFinite))throw new Error(`the plan has ${e.length} sides, ${t.length} numbers of steps and ${n.length} of feet: three a step and six are wanted`);let s=(r,o)=>({x:r[3*o],y:r[3*o+1],yaw:r[3*o+2]});return{steps:e.map((r,o)=>({side:r===1?1:0,...s(t,o)})),feet:[s(n,0),s(n,1)],seconds:Number(i.duration)}}function Vy([i,e]){let t=Math.atan2(Math.sin(i.yaw)+Math.sin(e.yaw),Math.cos(i.yaw)+Math.cos(e.yaw));return{x:(i.x+e.x)/2,y:(i.y+e.y)/2,yaw:t}}function Wy({steps:i,feet:e}){let t=[...e],n=[{at:Vy(t),gone_m:0}];for(let s of i){t[s.side]=s;let[r,o]=[n[n.length-1],Vy(t)];n.push({at:o,gone_m:r.gone_m+Math.hypot(o.x-r.at.x,o.y-r.at.y)})}return n}function $y(i){return Wy(i).at(-1)?.gone_m??0}var nA=.02;function hp(i,{x:e,y:t},n=0){let s=Wy(i),r=.5,o=s[n],a={gone_m:o.gone_m,off_m:1/0};for(let c=n;c<s.length&&s[c].gone_m<o.gone_m+r;++c){let[h,u]=[s[c],s[c+1]??s[c]],[d,f]=[u.at.x-h.at.x,u.at.y-h.at.y],g=d*d+f*f,v=g>0?Math.min(Math.max(((e-h.at.x)*d+(t-h.at.y)*f)/g,0),1):0,m=Math.hypot(e-h.at.x-v*d,t-h.at.y-v*f);m<a.off_m-1e-9&&(a={gone_m:h.gone_m+v*(u.gone_m-h.gone_m),off_m:m})}let l=n;for(;l+1<s.length&&s[l+1].gone_m<=a.gone_m+nA;)l+=1;return{passed:l,left_m:Math.max($y(i)-a.gone_m,0)}}function Xy(i,e){return Math.min(Math.max(i.steps.length-e,0),i.steps.length)}function qy(i){let e=`${i.steps.length} step${i.steps.length===1?"":"s"}`,t=Number.isFinite(i.seconds)&&i.seconds>0?`, about ${i.seconds.toFixed(0)} s`:"";return`${e}, ${$y(i).toFixed(1)} m${t}`}var iA=.08;function up(i,e,t){let[n,s]=i;if(Math.hypot(e[0]-n,e[1]-s)>iA)return{x:n,y:s,yaw:Math.atan2(e[1]-s,e[0]-n)};let o=!t||Math.hypot(n-t.x,s-t.y)<.25;return{x:n,y:s,yaw:o?t?.yaw??0:Math.atan2(s-t.y,n-t.x)}}function Qh({x:i,y:e,yaw:t}){let n=s=>s.toFixed(2).replace("-","−");return`x ${n(i)} m, y ${n(e)} m, ${(t*180/Math.PI).toFixed(0).replace("-","−")}°`}var Yy=1,Zy=101,sA=1,rA=2,Qa=5e3,dp=15e3,oA=1e4,eu=class{constructor(e){this.robot=e}async play(){await this.ask("set_simulation_state",{state:{state:sA}},Qa,Zy)}async pause(){await this.ask("set_simulation_state",{state:{state:rA}},Qa,Zy)}async step(e){await this.ask("step_simulation",{steps:e},dp)}async reset(){await this.ask("reset_simulation",{scope:0},dp)}async setSpeed(e){await this.robot.order("/simulation/set_speed",{speed:e},Qa)}async seek(e){await this.robot.order("/simulation/seek",{time:e},dp)}async apply(e){await this.robot.order("/simulation/apply",{event:JSON.stringify(e)},Qa)}async plan({x:e,y:t,yaw:n}){return Gy(await this.robot.order("/simulation/plan",{x:e,y:t,yaw:n},oA))}async geometry(e){return vy(await this.robot.order("/simulation/geometry",{first:e},Qa))}async ask(e,t,n,s=Yy){let{result:r}=await this.robot.call(`/simulation/${e}`,t,n);if(!(r?.result===Yy||r?.result===s))throw new Fn(r?.error_message||`/simulation/${e} was refused with result ${r?.result}`)}};var aA=60,Ky=.05,jy=.5,Jy=([i,e])=>1-2*(i*i+e*e);function lA(i,e){let t=Ar(i.yaw-e.yaw),[n,s]=[Math.cos(t),Math.sin(t)];return{x:i.x-(n*e.x-s*e.y),y:i.y-(s*e.x+n*e.y),z:i.z-e.z,yaw:t}}var tu=class{trail=[];take({robot_time:e,base_place:t,base_height:n,base_turn:s}){let[r=NaN,o=NaN,a=NaN,l=NaN]=[e[0],...t,n[0]],c=s;!Number.isFinite(r+o+a+l+(c[3]??NaN))||Jy(c)<jy||(r<(this.trail.at(-1)?.time_s??0)&&(this.trail=[]),r===this.trail.at(-1)?.time_s&&this.trail.pop(),this.trail.push({time_s:r,seen:{x:o,y:a,z:l,yaw:er(c)}}),this.trail.length>aA&&this.trail.shift())}forget(){this.trail=[]}originFor({time_s:e,base:t,state:n,speed:s}){let r=t&&Jy(t.turn)>=jy?this.at(e,n==="playing"?Ky*Math.max(s,1):Ky):void 0;return t&&r&&lA(cA(t),r)}at(e,t){let n=this.trail.findIndex(l=>l.time_s>=e),[s,r]=[this.trail[n<0?this.trail.length-1:Math.max(n-1,0)],this.trail[n]];if(!r)return s&&e-s.time_s<=t?s.seen:void 0;if(!s||r.time_s<=s.time_s)return r.time_s-e<=t?r.seen:void 0;let o=(e-s.time_s)/(r.time_s-s.time_s),a=l=>s.seen[l]+o*(r.seen[l]-s.seen[l]);return{x:a("x"),y:a("y"),z:a("z"),yaw:s.seen.yaw+o*Ar(r.seen.yaw-s.seen.yaw)}}};function cA({place:[i,e,t],turn:n}){return{x:i,y:e,z:t,yaw:er(n)}}function nu(i,e){let t=n=>n.key==="Escape"&&i.close();window.addEventListener("keydown",t,{capture:!0}),i.classList.add("above"),i.addEventListener("close",()=>{window.removeEventListener("keydown",t,{capture:!0}),i.remove(),e()}),document.body.append(i),i.show()}function el({recorded_s:i}){return Math.max(i,1)}function tl(i,e){return Math.min(Math.max(i/e,0),1)}function fp(i,{recorded_s:e}){let t=Math.min(Math.max(i,0)*el({recorded_s:e}),e);return Math.min(Math.round(t*1e3),Math.floor(e*1e3+1e-6))/1e3}var Qn=i=>`${i.toFixed(3)} s`,hA=5e-4;function iu(i,e){let t=e-i;return t>hA?`The ${Qn(t)} after this instant will be forgotten when it plays on.`:""}var Qy={command:"command",push:"push",fault:"fault",world:"change of the world",fall:"fall"};function ev(i,e,t){let n=[],s=new Map;for(let{at_s:r,kind:o}of[...i].sort((a,l)=>a.at_s-l.at_s)){let a=tl(r,e),l=s.get(o);if(l&&a-l.share<t){l.count+=1;continue}let c={share:a,kind:o,count:1,at_s:r};n.push(c),s.set(o,c)}return n}function tv({kind:i,count:e,at_s:t}){return e===1?`${Qy[i]} at ${Qn(t)}`:`${e} × ${Qy[i]} from ${Qn(t)}`}function nv(i){return[.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600].find(t=>i/t<=10)??Math.ceil(i/36e3)*3600}function iv(i){let e=document.getElementById("reset-keep");return e?(e.focus(),Promise.resolve(!1)):new Promise(t=>{let n=A("dialog",{id:"reset-dialog","aria-labelledby":"reset-title"},A("h2",{id:"reset-title"},"Back to 0 s?"),A("p",{},`The robot and the world begin anew, and all that is recorded is forgotten, ${Qn(i)} by now.`),A("div",{class:"answers"},ke("Keep it",()=>n.close(),{class:"plain",id:"reset-keep"}),ke("Reset",()=>n.close("reset"),{id:"reset-go"})));nu(n,()=>t(n.returnValue==="reset"))})}var su=class{constructor(e,t,n=()=>performance.now()){this.seek=e;this.failed=t;this.now_ms=n}wish_s;goes=!1;arrived_ms=0;target_s;get isGoing(){return this.goes}async to(e){if(this.wish_s=e,this.target_s=e,!this.goes){this.goes=!0;try{for(;this.wish_s!==void 0;){let t=this.wish_s;this.wish_s=void 0,await this.seek(t)}}catch(t){this.wish_s=this.target_s=void 0,this.failed(t)}finally{this.goes=!1,this.arrived_ms=this.now_ms()}}}told(e){this.goes||this.target_s===void 0||(Math.abs(e-this.target_s)<.0015||this.now_ms()-this.arrived_ms>500)&&(this.target_s=void 0)}};var uA={ArrowLeft:-.1,ArrowRight:.1,PageDown:-1,PageUp:1},dA=5,ru=class{constructor(e,t){this.seek=e;this.target=t;this.line=A("div",{class:"time-line",id:"time-line",role:"slider",tabindex:0,"aria-label":"Time line","aria-valuemin":0,title:"Click or drag: go to this instant. Arrows: 0.1 s, with Shift 1 s"},A("div",{class:"future"}),A("div",{class:"past"}),this.ticks,this.marks,A("div",{class:"head"}),this.bubble),this.box=A("div",{class:"time-line-box"},this.line),this.line.addEventListener("pointerdown",n=>this.begin(n)),this.line.addEventListener("pointermove",n=>this.move(n)),this.line.addEventListener("pointerup",n=>this.end(n)),this.line.addEventListener("pointercancel",()=>this.end()),this.line.addEventListener("pointerleave",()=>this.bubble.hidden=this.pointer===void 0),this.line.addEventListener("keydown",n=>this.key(n))}box;line;ticks=A("div",{class:"ticks"});marks=A("div",{class:"marks"});bubble=A("span",{class:"bubble",hidden:!0});state;pointer;dragged_s;drawnMarks="";drawnTicks="";show(e){this.state=e;let t=el(e),n=this.dragged_s??this.target()??e.time_s;this.line.style.setProperty("--now",String(tl(n,t))),this.line.style.setProperty("--recorded",String(tl(e.recorded_s,t))),this.line.classList.toggle("forgets",e.state!=="playing"&&iu(n,e.recorded_s)!==""),this.line.setAttribute("aria-valuemax",e.recorded_s.toFixed(3)),this.line.setAttribute("aria-valuenow",n.toFixed(3)),this.line.setAttribute("aria-valuetext",`${Qn(n)} of ${Qn(e.recorded_s)}`),this.showMarks(e,t),this.showTicks(t)}get time_s(){return this.dragged_s??this.target()}showMarks(e,t){let n=Math.max(this.line.clientWidth,100),s=ev(e.marks,t,dA/n),r=s.map(({share:o,kind:a,count:l})=>`${a}${Math.round(o*n)}x${l}`).join();r!==this.drawnMarks&&(this.drawnMarks=r,this.marks.replaceChildren(...s.map(o=>{let a=e.events.find(({at_s:c})=>Math.abs(c-o.at_s)<.0015),l=A("i",{class:o.kind,title:tv(o)+(a&&o.count===1?`: ${a.text}`:"")});return l.style.setProperty("--at",String(o.share)),l})))}showTicks(e){let t=nv(e),n=Math.floor(e/t+1e-9),s=`${t}x${n}/${Math.round(this.line.clientWidth)}`;for(let r of this.ticks.children)r.style.setProperty("--at",String(Number(r.dataset.s)/e));s!==this.drawnTicks&&(this.drawnTicks=s,this.ticks.replaceChildren(...Array.from({length:n+1},(r,o)=>{let a=o*t,l=A("b",{"data-s":a},t<1?a.toFixed(1):a.toFixed(0));return l.style.setProperty("--at",String(a/e)),l})))}instant(e){let{left:t,width:n}=this.line.getBoundingClientRect();return this.state?fp((e.clientX-t)/n,this.state):0}begin(e){e.button!==0||!this.state||(this.pointer=e.pointerId,this.line.setPointerCapture(e.pointerId),this.go(e))}move(e){e.pointerId===this.pointer?this.go(e):e.buttons===0&&this.tell(e)}end(e){e&&e.pointerId!==this.pointer||(this.pointer=void 0,this.dragged_s=void 0,e?.pointerType!=="mouse"&&(this.bubble.hidden=!0))}go(e){this.tell(e);let t=this.instant(e);t!==this.dragged_s&&(this.dragged_s=t,this.seek(t),this.state&&this.show(this.state))}tell(e){if(!this.state)return;let t=this.instant(e);he(this.bubble,Qn(t)),this.bubble.style.setProperty("--at",String(tl(t,el(this.state)))),this.bubble.hidden=!1}key(e){let t=uA[e.key],n={Home:0,End:this.state?.recorded_s??0};if(!this.state||t===void 0&&n[e.key]===void 0)return;e.preventDefault(),e.stopPropagation();let s=this.time_s??this.state.time_s,r=t===void 0?n[e.key]??0:s+t*(e.shiftKey?10:1);this.seek(fp(r/el(this.state),this.state)),this.show(this.state)}};var fA=[.1,.2,.5,1,2,5,10,20,40],sv=[1,10,80],pA=i=>i===""?"":`${i[0].toUpperCase()}${i.slice(1)}.`,ou=class{constructor(e,t,n){this.context=e;this.orders=t;this.seeker=new su(r=>this.leaveNow(()=>t.seek(r)),r=>e.news.say(`Going to an instant: ${r.message}`,"bad","seek")),this.timeLine=new ru(r=>void this.seeker.to(r),()=>this.seeker.target_s),this.playButton=ke("",()=>this.playOrPause(),{id:"play",class:"play","aria-keyshortcuts":"Space"}),this.stepButtons=sv.map(r=>ke(String(r),()=>this.step(r),{id:`step-${r}`,"aria-label":`One step of ${r} ms`})),this.speed=A("select",{id:"speed","aria-label":"Speed, in times real time",title:"Speed, in times real time"},...fA.map(r=>this.speedOption(r))),this.speed.addEventListener("change",()=>{this.setSpeed(Number(this.speed.value)),this.speed.blur()});let s=ke("Reset",()=>void this.reset(),{id:"reset",title:"Back to 0 s; what is recorded is forgotten"});this.box=A("section",{id:"simulator",class:"simulator","aria-label":"Simulator"},A("div",{class:"simulator-row"},this.playButton,A("span",{class:"steps",role:"group","aria-label":"Single steps"},A("small",{},"Step"),...this.stepButtons,A("small",{},"ms")),A("span",{class:"speed"},this.speed,this.pace),A("span",{class:"clocks"},this.clock,this.recorded),A("span",{class:"menus"},...n,s)),this.timeLine.box,this.note),this.nameSteps(),document.addEventListener("keydown",r=>this.key(r))}box;playButton;stepButtons;speed;pace=A("span",{class:"pace",title:"How fast it is, measured"});clock=A("output",{class:"clock",id:"simulator-time",title:"Simulated time"});recorded=A("span",{class:"recorded",title:"What has been simulated"});note=A("p",{class:"simulator-note",id:"simulator-note",role:"status"});timeLine;seeker;step_ms=10;state;silent=!1;show(e){this.state=e,this.seeker.told(e.time_s);let t=e.state==="playing",n=t?"Pause (Space)":"Play (Space)";this.playButton.classList.toggle("plays",t),this.playButton.title=n,this.playButton.setAttribute("aria-label",n),this.showSpeed(e);let s=this.timeLine.time_s??e.time_s;he(this.clock,Qn(s)),he(this.recorded,`of ${Qn(e.recorded_s)}`),this.timeLine.show(e),this.tell(e,s)}setSilent(e){e!==this.silent&&(this.silent=e,this.box.classList.toggle("silent",e),this.state&&this.tell(this.state,this.state.time_s))}tell(e,t){let n=e.state==="playing"?"":iu(t,e.recorded_s),s=this.silent?"The simulator does not answer.":e.state==="failed"?`The simulator has failed: ${e.text||"it does not say why"}`:e.state==="busy"?`Busy: ${e.text||"…"}`:this.seeker.isGoing&&this.seeker.target_s!==void 0?`Going to ${Qn(this.seeker.target_s)}…`:e.fallen?`The robot has fallen. ${n||"Drag the time line back to before, or reset."}`:n||pA(e.text);he(this.note,s),this.note.className=`simulator-note${this.silent||e.state==="failed"?" bad":e.state==="busy"?" busy":e.fallen?" caution":""}`}playOrPause(){let e=this.state?.state==="playing";this.quietly(e?"Pause":"Play",()=>e?this.orders.pause():this.orders.play())}step(e){this.step_ms=e,this.nameSteps(),this.quietly(`Step of ${e} ms`,async()=>{this.state?.state==="playing"&&await this.orders.pause(),await this.orders.step(e)})}nameSteps(){for(let[e,t]of sv.entries()){let n=t===this.step_ms?" (.)":"";this.stepButtons[e].title=`One step of ${t} ms${n}`}}setSpeed(e){this.quietly(`Speed ${e}`,()=>this.orders.setSpeed(e))}showSpeed({state:e,speed:t,pace:n}){document.activeElement!==this.speed&&Number(this.speed.value)!==t&&([...this.speed.options].some(r=>Number(r.value)===t)||this.speed.append(this.speedOption(t)),this.speed.value=String(t));let s=e==="playing"&&Number.isFinite(n);he(this.pace,s?`is ${n.toFixed(n<9.95?2:1)}`:""),this.pace.classList.toggle("bad",s&&n<.8*t)}speedOption(e){return A("option",{value:e},`${e} ×`)}async reset(){await iv(this.state?.recorded_s??0)&&await this.context.attempt("Reset",()=>this.leaveNow(()=>this.orders.reset()))}async leaveNow(e){let{command:t}=this.context;t.mine&&await t.giveBack().catch(()=>{}),await e()}async quietly(e,t){try{await t()}catch(n){this.context.news.say(`${e}: ${n.message}`,"bad",e)}}key(e){if(!(this.silent||!this.state||Js(e.target)||e.ctrlKey||e.altKey||e.metaKey||document.querySelector("dialog[open]"))){if(e.code==="Space"&&!e.repeat)this.playOrPause();else if(e.key===".")this.step(this.step_ms);else if(e.code!=="Space")return;e.preventDefault()}}};var au=class{constructor(e,t,n,s,r){this.picture=e;this.canvas=t;this.tools=n;this.turnBySecond=s;this.user=r;this.toggle=ke("Walk to",()=>this.setOn(!this.on),{"aria-pressed":"false",id:"walk-to",class:"walk-to",title:"Choose where the robot walks: click a place on the floor, drag for where it looks there"}),t.after(this.label);let o=(a,l)=>t.addEventListener(a,l,{capture:!0});o("pointerdown",a=>this.begin(a)),o("pointermove",a=>this.move(a)),o("pointerup",a=>this.end(a)),o("pointercancel",()=>this.cancel()),t.addEventListener("pointerleave",()=>this.label.hidden=!this.drag)}toggle;label=A("p",{class:"push-label",hidden:!0});drag;passes=!1;onToggle=()=>{};get on(){return this.toggle.getAttribute("aria-pressed")==="true"}setOn(e){e!==this.on&&(e&&this.tools.choose(this),this.toggle.setAttribute("aria-pressed",String(e)),this.canvas.classList.toggle("walks",e),this.turnBySecond(e),e||(this.cancel(),this.label.hidden=!0),this.onToggle(e))}cancel(){return this.drag?(this.drag=void 0,this.label.hidden=!0,this.user.broken(),!0):!1}floorAt(e){let t=this.picture.hitAt(e.clientX,e.clientY);if(t)return t.solid&&!Ka(t.solid)?{blocked:t.solid.name}:{place:[t.place[0],t.place[1]],height_m:t.place[2]}}begin(e){if(this.passes)return;if(this.drag){this.giveToCamera(this.drag.begun);return}let t=this.on&&e.button===0?this.floorAt(e):void 0;if(!t||"blocked"in t)return;e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId);let n=up(t.place,t.place,this.picture.robotPlace());this.drag={pointer:e.pointerId,from:t.place,height_m:t.height_m,begun:e,goal:n},this.aim(e,n)}giveToCamera(e){this.cancel(),this.passes=!0,this.canvas.dispatchEvent(new PointerEvent(e.type,e)),this.passes=!1}move(e){if(this.drag||this.tellPlace(e),e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let t=this.picture.levelAt(e.clientX,e.clientY,this.drag.height_m);t&&(this.drag.goal=up(this.drag.from,[t[0],t[1]],this.picture.robotPlace())),this.aim(e,this.drag.goal)}end(e){if(e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{goal:t}=this.drag;this.drag=void 0,this.label.hidden=!0,this.user.choose(t)}aim(e,t){this.user.aim(t),this.tell(e,Qh(t))}tellPlace(e){let t=this.on&&e.buttons===0&&e.pointerType==="mouse"?this.floorAt(e):void 0;this.label.hidden=!t,t&&("blocked"in t?this.tell(e,`${t.blocked} stands here`):this.tell(e,"Walk here"))}tell(e,t){he(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}};var pp={name:"/walk_to/state",type:"gaitway_msgs/msg/WayState"};function rv(i){let e=Array.isArray(i.goal)?i.goal.map(Number):[];return{goes:["plans","walks","waits"].includes(String(i.state)),result:String(i.result),text:String(i.text??""),stepsLeft:Number(i.steps_left),distanceLeft_m:Number(i.distance_left),replans:Number(i.replans),goal:e.length===3&&e.every(Number.isFinite)?{x:e[0],y:e[1],yaw:e[2]}:void 0}}function ov(i,e){return[Number.isFinite(e)?`${e.toFixed(1)} m`:"",i>0?`${i} step${i===1?"":"s"}`:""].filter(Boolean).join(", ")}var mp=(i,e)=>Math.hypot(i.x-e.x,i.y-e.y)<.005&&Math.abs(Math.sin((i.yaw-e.yaw)/2))<.005;var mA=4e3,lu=class{constructor(e,t){this.planner=e;this.walk=ke("Walk",t.walk,{class:"primary",id:"way-walk",title:"The robot walks there (Enter)"}),this.cancel=ke("Cancel",t.cancel,{id:"way-cancel",title:"Forget this goal (Escape)"}),this.leave=ke("Leave the way",t.leave,{id:"way-leave",title:"The robot stands after its next steps"}),this.box=A("div",{class:"way-card",id:"way",role:"group","aria-label":"Walk to a place",hidden:!0},this.text,this.more,this.walk,this.cancel,this.leave)}box;text=A("p",{role:"status",id:"way-text"});walk;cancel;leave;arrivedUntil_ms=0;went=!1;more=A("small",{},"Turn the view: the right button, or two fingers.");toolOn=!1;forget(){this.arrivedUntil_ms=0,this.went=!1}show(e){let{draft:t,way:n}=this.planner,s=n?.goes??!1;this.went&&!s&&n?.result==="arrived"&&(this.arrivedUntil_ms=e+mA),this.went=s;let r=!s&&!t&&e<this.arrivedUntil_ms;this.box.className=`way-card${t?.refusal?" refused":t?.plan?" ready":s?" goes":r?" arrived":""}`;let o=this.words(r);he(this.text,o),this.box.hidden=o==="";let a=!this.walk.hidden;this.more.hidden=t!==void 0||s||r,this.walk.hidden=!t?.plan,this.cancel.hidden=!t,this.leave.hidden=!s||t!==void 0,!a&&!this.walk.hidden&&(document.activeElement===document.body||document.activeElement===null)&&this.walk.focus({preventScroll:!0})}words(e){let{draft:t}=this.planner;if(t?.refusal!==void 0)return t.refusal;if(t?.plan)return t.plan.steps.length===0?"The robot stands there already.":qy(t.plan);if(t)return"Looking for a way…";let{left:n}=this.planner,s=n&&ov(n.steps,n.distance_m);return n?`On its way${s?`: ${s} left`:"…"}`:e?"Arrived.":this.toolOn?"Click the floor, then press Walk: the robot walks there. Drag to choose where it looks.":""}};var cu=class{constructor(e){this.plan=e}draft;way;walked;place;walkedTo;asked;onChange=()=>{};async choose(e){let t={goal:e};this.draft=t,this.onChange();try{t.plan=await this.plan(e)}catch(n){t.refusal=`${n instanceof Fn?"No way leads there":"No plan has come"}: ${n.message}`}this.draft===t&&this.onChange()}discard(){this.draft&&(this.draft=void 0,this.onChange())}begun(){let{draft:e}=this;this.walkedTo=e?.goal??this.walkedTo,e?.plan&&(this.walked=this.beginning(e.goal,e.plan),this.asked={goal:e.goal,replans:this.way?.replans??0}),this.draft=void 0,this.onChange()}jumped(){this.walked=this.asked=this.way=void 0,this.draft&&this.choose(this.draft.goal),this.onChange()}take(e){this.way=e,e.goes&&e.goal?this.keepWalked(e.goal,e.replans):e.goes||(this.walked=this.asked=void 0),this.onChange()}at(e){this.place=e;let{walked:t,way:n}=this;if(!t||!n?.goes)return;let s=hp(t.plan,e,t.progress.passed);s.passed=Math.max(Math.min(s.passed,Xy(t.plan,n.stepsLeft)),t.progress.passed),t.progress=s,this.onChange()}get goal(){return this.draft?.goal??this.walkedTo}get shown(){let{draft:e,way:t,walked:n}=this;return e?{goal:e.goal,plan:e.plan,passed:0}:n?{goal:n.goal,plan:n.plan,passed:n.progress.passed}:t?.goes&&t.goal?{goal:t.goal,plan:void 0,passed:0}:void 0}get left(){let{way:e,walked:t}=this;if(e?.goes)return t?{steps:t.plan.steps.length-t.progress.passed,distance_m:t.progress.left_m}:{steps:e.stepsLeft,distance_m:e.distanceLeft_m}}beginning(e,t){return{goal:e,plan:t,progress:hp(t,this.place??t.feet[0])}}keepWalked(e,t){let{asked:n}=this;if(n&&mp(n.goal,e)&&n.replans===t)return;if(n&&mp(n.goal,e)&&this.walked&&t===0){this.asked={goal:e,replans:t};return}let s={goal:e,replans:t};this.asked=s,this.plan(e).then(r=>{this.asked===s&&(this.walked=this.beginning(e,r),this.onChange())},()=>{})}};var gA=15e3,hu=class{constructor(e,t,n,s,r,o,a,l){this.context=e;this.orders=t;this.picture=n;this.plays=a;this.escapeStops=l;this.planner=new cu(c=>t.plan(c)),this.card=new lu(this.planner,{walk:()=>this.walk(),cancel:()=>this.planner.discard(),leave:()=>this.leave()}),this.tool=new au(n,r,o,c=>s.turnBySecond(c),{aim:c=>this.aim(c),choose:c=>{this.aimed=void 0,this.planner.choose(c)},broken:()=>this.aim(void 0)}),this.tool.onToggle=c=>{this.card.toolOn=c,c||this.planner.discard(),this.show()},this.planner.onChange=()=>this.show(),e.robot.subscribe(pp.name,pp.type,0,c=>this.planner.take(rv(c))),window.addEventListener("keydown",c=>{c.key!=="Escape"||!this.breakOff()||this.escapeStops()||(c.preventDefault(),c.stopImmediatePropagation())},{capture:!0})}tool;card;planner;aimed;drawn;drawnGoal;get goal(){return this.planner.goal}jumped(){this.card.forget(),this.planner.jumped()}worldChanged(){this.drawn=this.drawnGoal=void 0,this.show()}look(e){this.planner.at(this.picture.robotPlace()),this.card.show(e)}breakOff(){let e=this.tool.cancel(),t=this.planner.draft!==void 0;return this.planner.discard(),e||t}aim(e){this.aimed=e,this.show()}show(){let e=this.aimed?{goal:this.aimed,plan:void 0,passed:0}:this.planner.shown;e?(e.goal!==this.drawnGoal&&this.picture.showGoal(e.goal),e.plan!==this.drawn&&this.picture.showPlan(e.plan),this.picture.fadeSteps(e.passed)):this.picture.clearWay(),this.drawn=e?.plan,this.drawnGoal=e?.goal,this.card.show(performance.now())}walk(){let{attempt:e,command:t,robot:n}=this.context,s=this.planner.draft?.goal;s&&e("Walk to the goal",async()=>{this.plays()||await this.orders.play(),t.mine||await t.take(),await n.order("/walk_to",{x:s.x,y:s.y,yaw:s.yaw},gA),this.planner.draft?.goal===s&&this.planner.begun()},"begun")}leave(){let{attempt:e,command:t,robot:n}=this.context;e("Leave the way",async()=>{t.mine||await t.take(),await n.order("/walk_to/cancel")})}};var uu=class{constructor(e,t,n){this.part=e;this.show=t;this.failed=n}known;asks=!1;failed_ms=-1/0;forget(){this.known=void 0}async take(e,t){if(!(e===this.known||this.asks||t-this.failed_ms<2e3)){this.asks=!0;try{let{solids:n,floorColour:s,number:r}=await this.all();this.known=r,this.show(n,s)}catch(n){this.failed_ms=t,this.failed(n)}finally{this.asks=!1}}}async all(){let e=[],t;for(;;){let n=await this.part(e.length);if(t!==void 0&&n.geometry!==t){e.length=0,t=void 0;continue}if(t=n.geometry,e.push(...n.solids),e.length>=n.total)return{solids:e,floorColour:n.floorColour,number:t};if(n.solids.length===0)throw new Error(`the world has ${n.total} solids, of which only ${e.length} came`)}}};var gp=(i,e,t)=>e.map((n,s)=>{let r=i[s]??NaN;return Number.isFinite(r)?r+t*(n-r):n});function yA(i,e,t){let n=i.reduce((o,a,l)=>o+a*e[l],0)<0?-1:1,s=gp(i,e.map(o=>n*o),t),r=Math.hypot(...s);return r>1e-6?s.map(o=>o/r):e}var du=class{from;to;began_ms=0;takes_ms=100;take(e,t){let n=this.at(t),s=!n||Math.hypot(...e.base.place.map((r,o)=>r-n.base.place[o]))>.5;s||(this.takes_ms=Math.min(Math.max(t-this.began_ms,50),300)),this.from=s?e:n,this.to=e,this.began_ms=t}forget(){this.from=this.to=void 0}at(e){let{from:t,to:n}=this;if(!t||!n)return;let s=Math.min(Math.max((e-this.began_ms)/this.takes_ms,0),1);return s===1?n:{base:{place:gp(t.base.place,n.base.place,s),turn:yA(t.base.turn,n.base.turn,s)},joints:gp(t.joints,n.joints,s)}}arrived(e){return e-this.began_ms>=this.takes_ms}};var av=.55,vA=.16,_A=1,fu=class{group=new Ct;body;follower=new du;material=new us({blending:Uc,blendSrc:co,blendDst:ho,opacity:av,polygonOffset:!0,polygonOffsetFactor:-1,polygonOffsetUnits:-2});wanted=!0;constructor(e){this.body=new Yi(e),this.paint(),this.group.add(this.body.base),this.group.visible=!1}async loadMeshes(e,t){await this.body.loadMeshes(e,t)}setColour(e){this.material.color.setHex(e)}setWanted(e){this.wanted=e}setFaded(e){this.material.opacity=e?vA:av}show(e,t){e?this.follower.take(e,t):this.follower.forget()}settle(e){let t=this.wanted?this.follower.at(e):void 0;return this.group.visible=t!==void 0,t?(this.body.base.position.fromArray(t.base.place),this.body.base.quaternion.fromArray(t.base.turn),this.body.pose(t.joints),!this.follower.arrived(e)):!1}paint(){this.body.base.traverse(e=>{e instanceof ft&&(e.material=this.material,e.renderOrder=_A)})}};var vp={name:"/simulation/twin",type:"gaitway_msgs/msg/TwinState"},lv=1e3,Hs=.5,xA=["connecting","connected","lost","refused"],bA=["idle","trying","sending","done","not passed","failed","stopped"],mu=i=>Array.isArray(i)?i:[],gu=i=>typeof i=="number"?i:NaN,pu=i=>mu(i).map(gu),ms=i=>typeof i=="string"?i:"",yp=i=>Math.max(0,Math.round(gu(i)))||0;function wA(i){let e=mu(i.units),[t,n,s,r]=["measured","simulated","difference","limits"].map(a=>pu(i[a])),o=(a,l)=>a[l]??NaN;return mu(i.channels).map((a,l)=>({name:String(a),unit:ms(e[l]),measured:o(t,l),simulated:o(n,l),difference:o(s,l),limit:o(r,l)>0?o(r,l):0}))}function cv(i){let e=String(i.state),t=xA.find(a=>a===e),n=pu(i.base),s=pu(i.joints),r=mu(i.told_texts),o=String(i.sending);return{robot:ms(i.robot),link:t??"lost",text:t?ms(i.text):`it is said to be '${e}', which this page does not know`,age_s:gu(i.age),activity:ms(i.activity),commander:ms(i.commander),follows:i.follows===!0,followsText:ms(i.follows_text),base:n.length===7&&n.every(Number.isFinite)?{place:n.slice(0,3),turn:n.slice(3)}:void 0,joints:s.length>0?s:void 0,lag_s:gu(i.lag),channels:wA(i),told:pu(i.told_times).map((a,l)=>({at_s:a,text:ms(r[l])})).reverse(),sending:bA.find(a=>a===o)??"idle",sendingWhat:ms(i.sending_what),sendingText:ms(i.sending_text),passed:yp(i.passed),tried:yp(i.tried),picture:yp(i.picture)}}var Lo=({sending:i})=>i==="trying"||i==="sending";var MA={rad:{unit:"°",times:180/Math.PI,decimals:1},m:{unit:"m",times:1,decimals:2},N:{unit:"N",times:1,decimals:0}},Cr=i=>i.replaceAll("_"," "),ko=i=>MA[i]??{unit:i,times:1,decimals:2};function Vs(i,e){if(!Number.isFinite(i))return"–";let t=ko(e),n=Math.abs(i*t.times).toFixed(t.decimals);return`${i<0&&Number(n)!==0?"−":""}${n}${t.unit==="°"?"":" "}${t.unit}`}var nl=({difference:i,limit:e})=>e>0?i/e:NaN,_p=i=>nl(i)>1;function il(i){let e=t=>{let n=nl(t);return Number.isNaN(n)?-1:n};return[...i].sort((t,n)=>e(n)-e(t))}function SA({name:i,difference:e},t){return i==="heading"?`looks ${(e*180/Math.PI).toFixed(0)}° aside`:i.startsWith("place")?`stands ${Math.hypot(...t.filter(s=>s.name.startsWith("place")&&Number.isFinite(s.difference)).map(s=>s.difference)).toFixed(1)} m beside`:void 0}var TA={connecting:"is being connected",lost:"is lost",refused:"has been refused"};function hv({link:i,channels:e,follows:t,followsText:n},s){if(i!=="connected")return{verdict:"lost",text:`Nothing is compared: the robot there ${TA[i]}.`,short:`Robot there: ${i}`};if(!(s<=Hs))return{verdict:"lost",text:"Nothing is compared: the robot there tells nothing new.",short:"Robot there: old"};if(!t)return{verdict:"unknown",text:`Not compared: ${n||"the simulated robot does not do what the robot there does"}.`,short:n?`Not compared: ${n}`:"Not compared"};let r=il(e).filter(u=>Number.isFinite(nl(u))),[o]=r;if(!o)return{verdict:"unknown",text:"Not compared: nothing is known of the last 2 s yet.",short:"Not compared yet"};let[a,l]=[Cr(o.name),Vs(o.difference,o.unit)],c=r.filter(_p).length,h=`${a}, ${l} (limit ${Vs(o.limit,o.unit)})`;return c===0?{verdict:"agree",text:`Real and simulated agree. The largest difference: ${h}.`,short:"Real and simulated agree"}:{verdict:"differ",text:`${c} of ${r.length} differ. Most of all: ${h}.`,short:SA(o,e)??`${a} differs by ${l}`}}var EA="uplot",AA="u-hz",RA="u-vt",CA="u-title",PA="u-wrap",IA="u-under",LA="u-over",kA="u-axis",Lr="u-off",DA="u-select",NA="u-cursor-x",FA="u-cursor-y",UA="u-cursor-pt",OA="u-legend",BA="u-live",zA="u-inline",HA="u-series",VA="u-marker",uv="u-label",GA="u-value",rl="width",ol="height";var dv="bottom",Do="left",xp="right",Up="#000",fv=Up+"0",bp="mousemove",pv="mousedown",wp="mouseup",mv="mouseenter",gv="mouseleave",yv="dblclick",WA="resize",$A="scroll",vv="change",bu="dppxchange",Op="--",Ho=typeof window<"u",Ap=Ho?document:null,Fo=Ho?window:null,XA=Ho?navigator:null,St,yu;function Rp(){let i=devicePixelRatio;St!=i&&(St=i,yu&&Pp(vv,yu,Rp),yu=matchMedia(`(min-resolution: ${St-.001}dppx) and (max-resolution: ${St+.001}dppx)`),kr(vv,yu,Rp),Fo.dispatchEvent(new CustomEvent(bu)))}function ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Cp(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Ci(i,e,t,n){let s=Ap.createElement(i);return e!=null&&ei(s,e),t?.insertBefore(s,n),s}function fi(i,e){return Ci("div",i,e)}var _v=new WeakMap;function Zi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=_v.get(i);r!=o&&(i.style.transform=r,_v.set(i,r),e<0||t<0||e>n||t>s?ei(i,Lr):Cp(i,Lr))}var xv=new WeakMap;function bv(i,e,t){let n=e+t,s=xv.get(i);n!=s&&(xv.set(i,n),i.style.background=e,i.style.borderColor=t)}var wv=new WeakMap;function Mv(i,e,t,n){let s=e+""+t,r=wv.get(i);s!=r&&(wv.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Bp={passive:!0},qA={...Bp,capture:!0};function kr(i,e,t,n){e.addEventListener(i,t,n?qA:Bp)}function Pp(i,e,t,n){e.removeEventListener(i,t,Bp)}Ho&&Rp();function Pi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ti((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function jv(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Jv=i=>i!=null,Qv=i=>i!=null&&i>0,Su=jv(Jv),YA=jv(Qv);function ZA(i,e,t,n=0,s=!1){let r=s?YA:Su,o=s?Qv:Jv;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Nt,l??-Nt]}function Tu(i,e,t,n){let s=Ev(i),r=Ev(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?gs:e_,a=s==1?ti:pi,l=r==1?pi:ti,c=a(o(un(i))),h=l(o(un(e))),u=Uo(t,c),d=Uo(t,h);return t==10&&(c<0&&(u=Ft(u,-c)),h<0&&(d=Ft(d,-h))),n||t==2?(i=u*s,e=d*r):(i=s_(i,u),e=Eu(e,d)),[i,e]}function zp(i,e,t,n){let s=Tu(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Hp=.1,Sv={mode:3,pad:Hp},ll={pad:0,soft:null,mode:0},KA={min:ll,max:ll};function wu(i,e,t,n){return Au(t)?Tv(i,e,t):(ll.pad=t,ll.soft=n?0:null,ll.mode=n?3:0,Tv(i,e,KA))}function bt(i,e){return i??e}function jA(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Tv(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),o=bt(s.pad,0),a=bt(n.hard,-Nt),l=bt(s.hard,Nt),c=bt(n.soft,Nt),h=bt(s.soft,-Nt),u=bt(n.mode,0),d=bt(s.mode,0),f=e-i,g=gs(f),v=Bn(un(i),un(e)),m=gs(v),p=un(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=Nt&&(r=0),d==2&&h!=-Nt&&(o=0)));let M=f||v||1e3,b=gs(M),_=Uo(10,ti(b)),I=M*(f==0?i==0?.1:1:r),R=Ft(s_(i-I,_/10),24),D=i>=c&&(u==1||u==3&&R<=c||u==2&&R>=c)?c:Nt,N=Bn(a,R<D&&i>=D?D:Ii(D,R)),T=M*(f==0?e==0?.1:1:o),S=Ft(Eu(e+T,_/10),24),C=e<=h&&(d==1||d==3&&S>=h||d==2&&S<=h)?h:-Nt,B=Ii(l,S>C&&e<=C?C:Bn(C,S));return N==B&&N==0&&(B=100),[N,B]}var JA=new Intl.NumberFormat(Ho?XA.language:"en-US"),Vp=i=>JA.format(i),ni=Math,xu=ni.PI,un=ni.abs,ti=ni.floor,hn=ni.round,pi=ni.ceil,Ii=ni.min,Bn=ni.max,Uo=ni.pow,Ev=ni.sign,gs=ni.log10,e_=ni.log2,QA=(i,e=1)=>ni.sinh(i)*e,Mp=(i,e=1)=>ni.asinh(i/e),Nt=1/0;function Av(i){return(gs((i^i>>31)-(i>>31))|0)+1}function Ip(i,e,t){return Ii(Bn(i,e),t)}function t_(i){return typeof i=="function"}function mt(i){return t_(i)?i:()=>i}var eR=()=>{},n_=i=>i,i_=(i,e)=>e,tR=i=>null,Rv=i=>!0,Cv=(i,e)=>i==e,nR=/\.\d*?(?=9{6,}|0{6,})/gm,Dr=i=>{if(o_(i)||Ws.has(i))return i;let e=`${i}`,t=e.match(nR);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Dr(s)}e${r}`}return Ft(i,n)};function Pr(i,e){return Dr(Ft(Dr(i/e))*e)}function Eu(i,e){return Dr(pi(Dr(i/e))*e)}function s_(i,e){return Dr(ti(Dr(i/e))*e)}function Ft(i,e=0){if(o_(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return hn(n)/t}var Ws=new Map;function r_(i){return((""+i).split(".")[1]||"").length}function hl(i,e,t,n){let s=[],r=n.map(r_);for(let o=e;o<t;o++){let a=un(o),l=Ft(Uo(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ft(h,u);s.push(d),Ws.set(d,u)}}return s}var cl={},Gp=[],Oo=[null,null],Gs=Array.isArray,o_=Number.isInteger,iR=i=>i===void 0;function Pv(i){return typeof i=="string"}function Au(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function sR(i){return i!=null&&typeof i=="object"}var rR=Object.getPrototypeOf(Uint8Array),a_="__proto__";function Bo(i,e=Au){let t;if(Gs(i)){let n=i.find(s=>s!=null);if(Gs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Bo(i[s],e)}else t=i.slice()}else if(i instanceof rR)t=i.slice();else if(e(i)){t={};for(let n in i)n!=a_&&(t[n]=Bo(i[n],e))}else t=i;return t}function sn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=a_&&(Au(i[s])?sn(i[s],Bo(n[s])):i[s]=Bo(n[s]))}return i}var oR=0,aR=1,lR=2;function cR(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function hR(i,e){if(fR(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return pR(o[0])||(o=dR(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:aR,f=[];for(let g=0;g<h.length;g++){let v=h[g],m=r.get(l[g]);v===null?d!=oR&&(u[m]=v,d==lR&&f.push(m)):u[m]=v}cR(u,f,s),n.push(u)}}return n}var uR=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function dR(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function fR(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function pR(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Bn(1,ti((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var l_=["January","February","March","April","May","June","July","August","September","October","November","December"],c_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function h_(i){return i.slice(0,3)}var mR=c_.map(h_),gR=l_.map(h_),yR={MMMM:l_,MMM:gR,WWWW:c_,WWW:mR};function sl(i){return(i<10?"0":"")+i}function vR(i){return(i<10?"00":i<100?"0":"")+i}var _R={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>sl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>sl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>sl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>sl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>sl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>vR(i.getMilliseconds())};function Wp(i,e){e=e||yR;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?_R[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var xR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function bR(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==xR?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var u_=i=>i%1==0,Mu=[1,2,2.5,5],wR=hl(10,-32,0,Mu),d_=hl(10,0,32,Mu),MR=d_.filter(u_),Ir=wR.concat(d_),$p=`
`,f_="{YYYY}",Iv=$p+f_,p_="{M}/{D}",al=$p+p_,vu=al+"/{YY}",m_="{aa}",SR="{h}:{mm}",No=SR+m_,Lv=$p+No,kv=":{ss}",Et=null;function g_(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?hl(10,0,3,Mu).filter(u_):hl(10,-3,0,Mu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,f_,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Iv,Et,Et,Et,Et,Et,1],[s,p_,Iv,Et,Et,Et,Et,Et,1],[n,"{h}"+m_,vu,Et,al,Et,Et,Et,1],[t,No,vu,Et,al,Et,Et,Et,1],[e,kv,vu+" "+No,Et,al+" "+No,Et,Lv,Et,1],[i,kv+".{fff}",vu+" "+No,Et,al+" "+No,Et,Lv,Et,1]];function h(u){return(d,f,g,v,m,p)=>{let M=[],b=m>=o,_=m>=r&&m<o,I=u(g),R=Ft(I*i,3),D=Sp(I.getFullYear(),b?0:I.getMonth(),_||b?1:I.getDate()),N=Ft(D*i,3);if(_||b){let T=_?m/r:0,S=b?m/o:0,C=R==N?R:Ft(Sp(D.getFullYear()+S,D.getMonth()+T,1)*i,3),B=new Date(hn(C/i)),V=B.getFullYear(),$=B.getMonth();for(let X=0;C<=v;X++){let q=Sp(V+S*X,$+T*X,1),Q=q-u(Ft(q*i,3));C=Ft((+q+Q)*i,3),C<=v&&M.push(C)}}else{let T=m>=s?s:m,S=ti(g)-ti(R),C=N+S+Eu(R-N,T);M.push(C);let B=u(C),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/n,$=m/n,X=d.axes[f]._space,q=p/X;for(;C=Ft(C+m,i==1?0:3),!(C>v);)if($>1){let Q=ti(Ft(V+$,6))%24,le=u(C).getHours()-Q;le>1&&(le=-1),C-=le*n,V=(V+$)%24;let _e=M[M.length-1];Ft((C-_e)/m,3)*q>=.7&&M.push(C)}else M.push(C)}return M}}return[l,c,h]}var[TR,ER,AR]=g_(1),[RR,CR,PR]=g_(.001);hl(2,-53,53,[1]);function Dv(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Nv(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let v=i(g),m=v.getFullYear(),p=v.getMonth(),M=v.getDate(),b=v.getHours(),_=v.getMinutes(),I=v.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||M!=h&&a[4]||b!=u&&a[5]||_!=d&&a[6]||I!=f&&a[7]||a[1];return l=m,c=p,h=M,u=b,d=_,f=I,R(v)})}}function IR(i,e){let t=Wp(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Sp(i,e,t){return new Date(i,e,t)}function Fv(i,e){return e(i)}var LR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Uv(i,e){return(t,n,s,r)=>r==null?Op:e(i(n))}function kR(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function DR(i,e){return i.series[e].fill(i,e)}var NR={show:!0,live:!0,isolate:!1,mount:eR,markers:{show:!0,width:2,stroke:kR,fill:DR,dash:"solid"},idx:null,idxs:null,values:[]};function FR(i,e){let t=i.cursor.points,n=fi(),s=t.size(i,e);Yt(n,rl,s),Yt(n,ol,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function UR(i,e){let t=i.series[e].points;return t._fill||t._stroke}function OR(i,e){let t=i.series[e].points;return t._stroke||t._fill}function BR(i,e){return i.series[e].points.size}var Tp=[0,0];function zR(i,e,t){return Tp[0]=e,Tp[1]=t,Tp}function _u(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ep(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var HR={show:!0,x:!0,y:!0,lock:!1,move:zR,points:{one:!1,show:FR,size:BR,width:0,stroke:OR,fill:UR},bind:{mousedown:_u,mouseup:_u,click:_u,dblclick:_u,mousemove:Ep,mouseleave:Ep,mouseenter:Ep},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},y_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xp=sn({},y_,{filter:i_}),v_=sn({},Xp,{size:10}),__=sn({},y_,{show:!1}),qp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',x_="bold "+qp,b_=1.5,Ov={show:!0,scale:"x",stroke:Up,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:x_,side:2,grid:Xp,ticks:v_,border:__,font:qp,lineGap:b_,rotate:0},VR="Value",GR="Time",Bv={show:!0,scale:"x",auto:!1,sorted:1,min:Nt,max:-Nt,idxs:[]};function WR(i,e,t,n,s){return e.map(r=>r==null?"":Vp(r))}function $R(i,e,t,n,s,r,o){let a=[],l=Ws.get(s)||0;t=o?t:Ft(Eu(t,s),l);for(let c=t;c<=n;c=Ft(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Lp(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?gs:e_,h=ti(c(t));s=Uo(l,h),l==10&&(s=Ir[Pi(s,Ir)]);let u=t,d=s*l;l==10&&(d=Ir[Pi(d,Ir)]);do a.push(u),u=u+s,l==10&&!Ws.has(u)&&(u=Ft(u,Ws.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ir[Pi(d,Ir)]));while(u<=n);return a}function XR(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Lp(i,e,Bn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Lp(i,e,Bn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var w_=/./,qR=/[12357]/,YR=/[125]/,zv=/1/,kp=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function ZR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?w_:l(7,o)-h>=c?qR:l(5,o)-h>=c?YR:zv;if(u==zv){let d=un(l(1,o)-h);if(d<c)return kp(e.slice().reverse(),a.distr,u,pi(c/d)).reverse()}return kp(e,a.distr,u,1)}function KR(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=un(l(1,o)-l(2,o));return c<a?kp(e.slice().reverse(),3,w_,pi(a/c)).reverse():e}function jR(i,e,t,n){return n==null?Op:e==null?"":Vp(e)}var Hv={show:!0,scale:"y",stroke:Up,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:x_,side:3,grid:Xp,ticks:v_,border:__,font:qp,lineGap:b_,rotate:0};function JR(i,e){let t=3+(i||1)*2;return Ft(t*e,3)}function QR(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=un(o-r),l=i.series[e],c=a/(l.points.space*St);return n[1]-n[0]<=c}var Vv={scale:null,auto:!0,sorted:0,min:Nt,max:-Nt},M_=(i,e,t,n,s)=>s,Gv={show:!0,auto:!0,sorted:0,gaps:M_,alpha:1,facets:[sn({},Vv,{scale:"x"}),sn({},Vv,{scale:"y"})]},Wv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:M_,alpha:1,points:{show:QR,filter:null},values:null,min:Nt,max:-Nt,idxs:[],path:null,clip:null};function eC(i,e,t,n,s){return t/10}var S_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},tC=sn({},S_,{time:!1,ori:1}),$v={};function T_(i,e){let t=$v[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&($v[i]=t)),t}var zo=1,Dp=2;function Nr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,v=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,p,d,f,g,v,Cu,Vo,Iu,A_,C_):t(s,l,c,h,u,p,m,f,d,v,g,Pu,Go,Kp,R_,P_)}function Yp(i,e){let t=0,n=0,s=bt(i.bands,Gp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function nC(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(i,e,t,n,s,r){return Nr(i,e,(o,a,l,c,h,u,d,f,g,v,m)=>{let p=o.pxRound,M=c.dir*(c.ori==0?1:-1),b=c.ori==0?Vo:Go,_,I;M==1?(_=t,I=n):(_=n,I=t);let R=p(u(a[_],c,v,f)),D=p(d(l[_],h,m,g)),N=p(u(a[I],c,v,f)),T=p(d(r==1?h.max:h.min,h,m,g)),S=new Path2D(s);return b(S,N,T),b(S,R,T),b(S,R,D),S})}function Ru(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Iu:Kp,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function iC(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Zp(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),v=u-s;f=o<=0&&v>=0&&v<l?r(i[v]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function Xv(i){return i==0?n_:i==1?hn:e=>Pr(e,i)}function E_(i){let e=i==0?Cu:Pu,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Ii(c,a/2,l/2),h=Ii(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Cu=(i,e,t)=>{i.moveTo(e,t)},Pu=(i,e,t)=>{i.moveTo(t,e)},Vo=(i,e,t)=>{i.lineTo(e,t)},Go=(i,e,t)=>{i.lineTo(t,e)},Iu=E_(0),Kp=E_(1),A_=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},R_=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},C_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},P_=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function I_(i){return(e,t,n,s,r)=>Nr(e,t,(o,a,l,c,h,u,d,f,g,v,m)=>{let{pxRound:p,points:M}=o,b,_;c.ori==0?(b=Cu,_=A_):(b=Pu,_=R_);let I=Ft(M.width*St,3),R=(M.size-M.width)/2*St,D=Ft(R*2,3),N=new Path2D,T=new Path2D,{left:S,top:C,width:B,height:V}=e.bbox;Iu(T,S-D,C-D,B+D*2,V+D*2);let $=X=>{if(l[X]!=null){let q=p(u(a[X],c,v,f)),Q=p(d(l[X],h,m,g));b(N,q+R,Q),_(N,q,Q,R,0,xu*2)}};if(r)r.forEach($);else for(let X=n;X<=s;X++)$(X);return{stroke:I>0?N:null,fill:N,clip:T,flags:zo|Dp}})}function L_(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var sC=L_(Vo),rC=L_(Go);function k_(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>Nr(t,n,(o,a,l,c,h,u,d,f,g,v,m)=>{[s,r]=Su(l,s,r);let p=o.pxRound,M=V=>p(u(V,c,v,f)),b=V=>p(d(V,h,m,g)),_,I;c.ori==0?(_=Vo,I=sC):(_=Go,I=rC);let R=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zo},N=D.stroke,T=!1;if(r-s>=v*4){let V=ve=>t.posToVal(ve,c.key,!0),$=null,X=null,q,Q,Z,ae=M(a[R==1?s:r]),le=M(a[s]),_e=M(a[r]),Me=V(R==1?le+1:_e-1);for(let ve=R==1?s:r;ve>=s&&ve<=r;ve+=R){let rt=a[ve],ee=(R==1?rt<Me:rt>Me)?ae:M(rt),ne=l[ve];ee==ae?ne!=null?(Q=ne,$==null?(_(N,ee,b(Q)),q=$=X=Q):Q<$?$=Q:Q>X&&(X=Q)):ne===null&&(T=!0):($!=null&&I(N,ae,b($),b(X),b(q),b(Q)),ne!=null?(Q=ne,_(N,ee,b(Q)),$=X=q=Q):($=X=null,ne===null&&(T=!0)),ae=ee,Me=V(ae+R))}$!=null&&$!=X&&Z!=ae&&I(N,ae,b($),b(X),b(q),b(Q))}else for(let V=R==1?s:r;V>=s&&V<=r;V+=R){let $=l[V];$===null?T=!0:$!=null&&_(N,M(a[V]),b($))}let[C,B]=Yp(t,n);if(o.fill!=null||C!=0){let V=D.fill=new Path2D(N),$=o.fillTo(t,n,o.min,o.max,C),X=b($),q=M(a[s]),Q=M(a[r]);R==-1&&([Q,q]=[q,Q]),_(V,Q,X),_(V,q,X)}if(!o.spanGaps){let V=[];T&&V.push(...Zp(a,l,s,r,R,M,e)),D.gaps=V=o.gaps(t,n,s,r,V),D.clip=Ru(V,c.ori,f,g,v,m)}return B!=0&&(D.band=B==2?[ys(t,n,s,r,N,-1),ys(t,n,s,r,N,1)]:ys(t,n,s,r,N,B)),D})}function oC(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,o,a,l)=>Nr(r,o,(c,h,u,d,f,g,v,m,p,M,b)=>{[a,l]=Su(u,a,l);let _=c.pxRound,{left:I,width:R}=r.bbox,D=le=>_(g(le,d,M,m)),N=le=>_(v(le,f,b,p)),T=d.ori==0?Vo:Go,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:zo},C=S.stroke,B=d.dir*(d.ori==0?1:-1),V=N(u[B==1?a:l]),$=D(h[B==1?a:l]),X=$,q=$;s&&e==-1&&(q=I,T(C,q,V)),T(C,$,V);for(let le=B==1?a:l;le>=a&&le<=l;le+=B){let _e=u[le];if(_e==null)continue;let Me=D(h[le]),ve=N(_e);e==1?T(C,Me,V):T(C,X,ve),T(C,Me,ve),V=ve,X=Me}let Q=X;s&&e==1&&(Q=I+R,T(C,Q,V));let[Z,ae]=Yp(r,o);if(c.fill!=null||Z!=0){let le=S.fill=new Path2D(C),_e=c.fillTo(r,o,c.min,c.max,Z),Me=N(_e);T(le,Q,Me),T(le,q,Me)}if(!c.spanGaps){let le=[];le.push(...Zp(h,u,a,l,B,D,n));let _e=c.width*St/2,Me=t||e==1?_e:-_e,ve=t||e==-1?-_e:_e;le.forEach(rt=>{rt[0]+=Me,rt[1]+=ve}),S.gaps=le=c.gaps(r,o,a,l,le),S.clip=Ru(le,d.ori,m,p,M,b)}return ae!=0&&(S.band=ae==2?[ys(r,o,a,l,C,-1),ys(r,o,a,l,C,1)]:ys(r,o,a,l,C,ae)),S})}function qv(i,e,t,n,s,r,o=Nt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=un(i[l]-i[a]);h<c&&(c=h,o=un(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function aC(i){i=i||cl;let e=bt(i.size,[.6,Nt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=mt(s),o=1-e[0],a=bt(e[1],Nt),l=bt(e[2],1),c=bt(i.disp,cl),h=bt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,v,m)=>Nr(f,g,(p,M,b,_,I,R,D,N,T,S,C)=>{let B=p.pxRound,V=t,$=n*St,X=a*St,q=l*St,Q,Z;_.ori==0?[Q,Z]=r(f,g):[Z,Q]=r(f,g);let ae=_.dir*(_.ori==0?1:-1),le=_.ori==0?Iu:Kp,_e=_.ori==0?h:(U,j,ie,te,Oe,de,De)=>{h(U,j,ie,Oe,te,De,de)},Me=bt(f.bands,Gp).find(U=>U.series[0]==g),ve=Me!=null?Me.dir:0,rt=p.fillTo(f,g,p.min,p.max,ve),et=B(D(rt,I,C,T)),ee,ne,Ee,Ve=S,xe=B(p.width*St),nt=!1,Ut=null,F=null,gt=null,je=null;u!=null&&(xe==0||d!=null)&&(nt=!0,Ut=u.values(f,g,v,m),F=new Map,new Set(Ut).forEach(U=>{U!=null&&F.set(U,new Path2D)}),xe>0&&(gt=d.values(f,g,v,m),je=new Map,new Set(gt).forEach(U=>{U!=null&&je.set(U,new Path2D)})));let{x0:Xe,size:Ue}=c;if(Xe!=null&&Ue!=null){V=1,M=Xe.values(f,g,v,m),Xe.unit==2&&(M=M.map(ie=>f.posToVal(N+ie*S,_.key,!0)));let U=Ue.values(f,g,v,m);Ue.unit==2?ne=U[0]*S:ne=R(U[0],_,S,N)-R(0,_,S,N),Ve=qv(M,b,R,_,S,N,Ve),Ee=Ve-ne+$}else Ve=qv(M,b,R,_,S,N,Ve),Ee=Ve*o+$,ne=Ve-Ee;Ee<1&&(Ee=0),xe>=ne/2&&(xe=0),Ee<5&&(B=n_);let At=Ee>0,Ie=Ve-Ee-(At?xe:0);ne=B(Ip(Ie,q,X)),ee=(V==0?ne/2:V==ae?0:ne)-V*ae*((V==0?$/2:0)+(At?xe/2:0));let $e={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Gt=nt?null:new Path2D,wt=null;if(Me!=null)wt=f.data[Me.series[1]];else{let{y0:U,y1:j}=c;U!=null&&j!=null&&(b=j.values(f,g,v,m),wt=U.values(f,g,v,m))}let L=Q*ne,x=Z*ne;for(let U=ae==1?v:m;U>=v&&U<=m;U+=ae){let j=b[U];if(j==null)continue;if(wt!=null){let ye=wt[U]??0;if(j-ye==0)continue;et=D(ye,I,C,T)}let ie=_.distr!=2||c!=null?M[U]:U,te=R(ie,_,S,N),Oe=D(bt(j,rt),I,C,T),de=B(te-ee),De=B(Bn(Oe,et)),Ce=B(Ii(Oe,et)),oe=De-Ce;if(j!=null){let ye=j<0?x:L,He=j<0?L:x;nt?(xe>0&&gt[U]!=null&&le(je.get(gt[U]),de,Ce+ti(xe/2),ne,Bn(0,oe-xe),ye,He),Ut[U]!=null&&le(F.get(Ut[U]),de,Ce+ti(xe/2),ne,Bn(0,oe-xe),ye,He)):le(Gt,de,Ce+ti(xe/2),ne,Bn(0,oe-xe),ye,He),_e(f,g,U,de-xe/2,Ce,ne+xe,oe)}}return xe>0?$e.stroke=nt?je:Gt:nt||($e._fill=p.width==0?p._fill:p._stroke??p._fill,$e.width=0),$e.fill=nt?F:Gt,$e})}function lC(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,o)=>Nr(n,s,(a,l,c,h,u,d,f,g,v,m,p)=>{[r,o]=Su(c,r,o);let M=a.pxRound,b=Q=>M(d(Q,h,m,g)),_=Q=>M(f(Q,u,p,v)),I,R,D;h.ori==0?(I=Cu,D=Vo,R=C_):(I=Pu,D=Go,R=P_);let N=h.dir*(h.ori==0?1:-1),T=b(l[N==1?r:o]),S=T,C=[],B=[];for(let Q=N==1?r:o;Q>=r&&Q<=o;Q+=N)if(c[Q]!=null){let ae=l[Q],le=b(ae);C.push(S=le),B.push(_(c[Q]))}let V={stroke:i(C,B,I,D,R,M),fill:null,clip:null,band:null,gaps:null,flags:zo},$=V.stroke,[X,q]=Yp(n,s);if(a.fill!=null||X!=0){let Q=V.fill=new Path2D($),Z=a.fillTo(n,s,a.min,a.max,X),ae=_(Z);D(Q,S,ae),D(Q,T,ae)}if(!a.spanGaps){let Q=[];Q.push(...Zp(l,c,r,o,N,b,t)),V.gaps=Q=a.gaps(n,s,r,o,Q),V.clip=Ru(Q,h.ori,g,v,m,p)}return q!=0&&(V.band=q==2?[ys(n,s,r,o,$,-1),ys(n,s,r,o,$,1)]:ys(n,s,r,o,$,q)),V})}function cC(i){return lC(hC,i)}function hC(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var Np=new Set;function Yv(){for(let i of Np)i.syncRect(!0)}Ho&&(kr(WA,Fo,Yv),kr($A,Fo,Yv,!0),kr(bu,Fo,()=>{dn.pxRatio=St}));var uC=k_(),dC=I_();function Zv(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Fp(r,o,e,t))}function fC(i,e){return i.map((t,n)=>n==0?{}:sn({},e,t))}function Fp(i,e,t,n){return sn({},e==0?t:n,i)}function D_(i,e,t){return e==null?Oo:[e,t]}var pC=D_;function mC(i,e,t){return e==null?Oo:wu(e,t,Hp,!0)}function N_(i,e,t,n){return e==null?Oo:Tu(e,t,i.scales[n].log,!1)}var gC=N_;function F_(i,e,t,n){return e==null?Oo:zp(e,t,i.scales[n].log,!1)}var yC=F_;function vC(i,e,t,n,s){let r=Bn(Av(i),Av(e)),o=e-i,a=Pi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ws.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Kv(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=hn((t=+s)*St))+"px"),[i,e,t]}function _C(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ft(e[2]*St,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function dn(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(y,w,P,k){let H=w.valToPct(y);return k+P*(w.dir==-1?1-H:H)}function o(y,w,P,k){let H=w.valToPct(y);return k+P*(w.dir==-1?H:1-H)}function a(y,w,P,k){return w.ori==0?r(y,w,P,k):o(y,w,P,k)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=fi(EA);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let y=fi(CA,c);y.textContent=i.title}let h=Ci("canvas"),u=n.ctx=h.getContext("2d"),d=fi(PA,c);kr("click",d,y=>{y.target===g&&(Wt!=Hr||Zt!=Vr)&&wn.click(n,y)},!0);let f=n.under=fi(IA,d);d.appendChild(h);let g=n.over=fi(LA,d);i=Bo(i);let v=+bt(i.pxAlign,1),m=Xv(v);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let p=i.ms||.001,M=n.series=s==1?Zv(i.series||[],Bv,Wv,!1):fC(i.series||[null],Gv),b=n.axes=Zv(i.axes||[],Ov,Hv,!0),_=n.scales={},I=n.bands=i.bands||[];I.forEach(y=>{y.fill=mt(y.fill||null),y.dir=bt(y.dir,-1)});let R=s==2?M[1].facets[0].scale:M[0].scale,D={axes:Ox,series:qs},N=(i.drawOrder||["axes","series"]).map(y=>D[y]);function T(y){let w=y.distr==3?P=>gs(P>0?P:y.clamp(n,P,y.min,y.max,y.key)):y.distr==4?P=>Mp(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let k=w(P),{_min:H,_max:Y}=y,se=Y-H;return(k-H)/se}}function S(y){let w=_[y];if(w==null){let P=(i.scales||cl)[y]||cl;if(P.from!=null){S(P.from);let k=sn({},_[P.from],P,{key:y});k.valToPct=T(k),_[y]=k}else{w=_[y]=sn({},y==R?S_:tC,P),w.key=y;let k=w.time,H=w.range,Y=Gs(H);if((y!=R||s==2&&!k)&&(Y&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?Sv:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?Sv:{mode:1,hard:H[1],soft:H[1]}},Y=!1),!Y&&Au(H))){let se=H;H=(ce,ge,Re)=>ge==null?Oo:wu(ge,Re,se)}w.range=mt(H||(k?pC:y==R?w.distr==3?gC:w.distr==4?yC:D_:w.distr==3?N_:w.distr==4?F_:mC)),w.auto=mt(Y?!1:w.auto),w.clamp=mt(w.clamp||eC),w._min=w._max=null,w.valToPct=T(w)}}}S("x"),S("y"),s==1&&M.forEach(y=>{S(y.scale)}),b.forEach(y=>{S(y.scale)});for(let y in i.scales)S(y);let C=_[R],B=C.distr,V,$;C.ori==0?(ei(c,AA),V=r,$=o):(ei(c,RA),V=o,$=r);let X={};for(let y in _){let w=_[y];(w.min!=null||w.max!=null)&&(X[y]={min:w.min,max:w.max},w.min=w.max=null)}let q=i.tzDate||(y=>new Date(hn(y/p))),Q=i.fmtDate||Wp,Z=p==1?AR(q):PR(q),ae=Nv(q,Dv(p==1?ER:CR,Q)),le=Uv(q,Fv(LR,Q)),_e=[],Me=n.legend=sn({},NR,i.legend),ve=n.cursor=sn({},HR,{drag:{y:s==2}},i.cursor),rt=Me.show,et=ve.show,ee=Me.markers;Me.idxs=_e,ee.width=mt(ee.width),ee.dash=mt(ee.dash),ee.stroke=mt(ee.stroke),ee.fill=mt(ee.fill);let ne,Ee,Ve,xe=[],nt=[],Ut,F=!1,gt={};if(Me.live){let y=M[1]?M[1].values:null;F=y!=null,Ut=F?y(n,1,0):{_:0};for(let w in Ut)gt[w]=Op}if(rt)if(ne=Ci("table",OA,c),Ve=Ci("tbody",null,ne),Me.mount(n,ne),F){Ee=Ci("thead",null,ne,Ve);let y=Ci("tr",null,Ee);Ci("th",null,y);for(var je in Ut)Ci("th",uv,y).textContent=je}else ei(ne,zA),Me.live&&ei(ne,BA);let Xe={show:!0},Ue={show:!1};function At(y,w){if(w==0&&(F||!Me.live||s==2))return Oo;let P=[],k=Ci("tr",HA,Ve,Ve.childNodes[w]);ei(k,y.class),y.show||ei(k,Lr);let H=Ci("th",null,k);if(ee.show){let ce=fi(VA,H);if(w>0){let ge=ee.width(n,w);ge&&(ce.style.border=ge+"px "+ee.dash(n,w)+" "+ee.stroke(n,w)),ce.style.background=ee.fill(n,w)}}let Y=fi(uv,H);y.label instanceof HTMLElement?Y.appendChild(y.label):Y.textContent=y.label,w>0&&(ee.show||(Y.style.color=y.width>0?ee.stroke(n,w):ee.fill(n,w)),$e("click",H,ce=>{if(ve._lock)return;bn(ce);let ge=M.indexOf(y);if((ce.ctrlKey||ce.metaKey)!=Me.isolate){let Re=M.some((Pe,Fe)=>Fe>0&&Fe!=ge&&Pe.show);M.forEach((Pe,Fe)=>{Fe>0&&Di(Fe,Re?Fe==ge?Xe:Ue:Xe,!0,tn.setSeries)})}else Di(ge,{show:!y.show},!0,tn.setSeries)},!1),zn&&$e(mv,H,ce=>{ve._lock||(bn(ce),Di(M.indexOf(y),Wr,!0,tn.setSeries))},!1));for(var se in Ut){let ce=Ci("td",GA,k);ce.textContent="--",P.push(ce)}return[k,P]}let Ie=new Map;function $e(y,w,P,k=!0){let H=Ie.get(w)||{},Y=ve.bind[y](n,w,P,k);Y&&(kr(y,w,H[y]=Y),Ie.set(w,H))}function Gt(y,w,P){let k=Ie.get(w)||{};for(let H in k)(y==null||H==y)&&(Pp(H,w,k[H]),delete k[H]);y==null&&Ie.delete(w)}let wt=0,L=0,x=0,U=0,j=0,ie=0,te=j,Oe=ie,de=x,De=U,Ce=0,oe=0,ye=0,He=0;n.bbox={};let ze=!1,be=!1,Qe=!1,z=!1,fe=!1,me=!1;function Le(y,w,P){(P||y!=n.width||w!=n.height)&&ue(y,w),Ur(!1),Qe=!0,be=!0,Or()}function ue(y,w){n.width=wt=x=y,n.height=L=U=w,j=ie=0,It(),vt();let P=n.bbox;Ce=P.left=Pr(j*St,.5),oe=P.top=Pr(ie*St,.5),ye=P.width=Pr(x*St,.5),He=P.height=Pr(U*St,.5)}let re=3;function Be(){let y=!1,w=0;for(;!y;){w++;let P=Fx(w),k=Ux(w);y=w==re||P&&k,y||(ue(n.width,n.height),be=!0)}}function it({width:y,height:w}){Le(y,w)}n.setSize=it;function It(){let y=!1,w=!1,P=!1,k=!1;b.forEach((H,Y)=>{if(H.show&&H._show){let{side:se,_size:ce}=H,ge=se%2,Re=H.label!=null?H.labelSize:0,Pe=ce+Re;Pe>0&&(ge?(x-=Pe,se==3?(j+=Pe,k=!0):P=!0):(U-=Pe,se==0?(ie+=Pe,y=!0):w=!0))}}),ji[0]=y,ji[1]=P,ji[2]=w,ji[3]=k,x-=ki[1]+ki[3],j+=ki[3],U-=ki[2]+ki[0],ie+=ki[0]}function vt(){let y=j+x,w=ie+U,P=j,k=ie;function H(Y,se){switch(Y){case 1:return y+=se,y-se;case 2:return w+=se,w-se;case 3:return P-=se,P+se;case 0:return k-=se,k+se}}b.forEach((Y,se)=>{if(Y.show&&Y._show){let ce=Y.side;Y._pos=H(ce,Y._size),Y.label!=null&&(Y._lpos=H(ce,Y.labelSize))}})}if(ve.dataIdx==null){let y=ve.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let P=y.prox=mt(y.prox),k=y.bias??=0;ve.dataIdx=(H,Y,se,ce)=>{if(Y==0)return se;let ge=se,Re=P(H,Y,se,ce)??Nt,Pe=Re>=0&&Re<Nt,Fe=C.ori==0?x:U,st=ve.left,Mt=e[0],xt=e[Y];if(w.has(xt[se])){ge=null;let ut=null,Je=null,We;if(k==0||k==-1)for(We=se;ut==null&&We-- >0;)w.has(xt[We])||(ut=We);if(k==0||k==1)for(We=se;Je==null&&We++<xt.length;)w.has(xt[We])||(Je=We);if(ut!=null||Je!=null)if(Pe){let Xt=ut==null?-1/0:V(Mt[ut],C,Fe,0),Jt=Je==null?1/0:V(Mt[Je],C,Fe,0),vn=st-Xt,Lt=Jt-st;vn<=Lt?vn<=Re&&(ge=ut):Lt<=Re&&(ge=Je)}else ge=Je==null?ut:ut==null?Je:se-ut<=Je-se?ut:Je}else Pe&&un(st-V(Mt[se],C,Fe,0))>Re&&(ge=null);return ge}}let bn=y=>{ve.event=y};ve.idxs=_e,ve._lock=!1;let Dt=ve.points;Dt.show=mt(Dt.show),Dt.size=mt(Dt.size),Dt.stroke=mt(Dt.stroke),Dt.width=mt(Dt.width),Dt.fill=mt(Dt.fill);let Gn=n.focus=sn({},i.focus||{alpha:.3},ve.focus),zn=Gn.prox>=0,Li=zn&&Dt.one,Cn=[],Ki=[],yi=[];function $o(y,w){let P=Dt.show(n,w);if(P instanceof HTMLElement)return ei(P,UA),ei(P,y.class),Zi(P,-10,-10,x,U),g.insertBefore(P,Cn[w]),P}function $s(y,w){if(s==1||w>0){let P=s==1&&_[y.scale].time,k=y.value;y.value=P?Pv(k)?Uv(q,Fv(k,Q)):k||le:k||jR,y.label=y.label||(P?GR:VR)}if(Li||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||uC||tR,y.fillTo=mt(y.fillTo||nC),y.pxAlign=+bt(y.pxAlign,v),y.pxRound=Xv(y.pxAlign),y.stroke=mt(y.stroke||null),y.fill=mt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=JR(Bn(1,y.width),1),k=y.points=sn({},{size:P,width:Bn(1,P*.2),stroke:y.stroke,space:P*2,paths:dC,_stroke:null,_fill:null},y.points);k.show=mt(k.show),k.filter=mt(k.filter),k.fill=mt(k.fill),k.stroke=mt(k.stroke),k.paths=mt(k.paths),k.pxAlign=y.pxAlign}if(rt){let P=At(y,w);xe.splice(w,0,P[0]),nt.splice(w,0,P[1]),Me.values.push(null)}if(et){_e.splice(w,0,null);let P=null;Li?w==0&&(P=$o(y,w)):w>0&&(P=$o(y,w)),Cn.splice(w,0,P),Ki.splice(w,0,0),yi.splice(w,0,0)}yn("addSeries",w)}function ml(y,w){w=w??M.length,y=s==1?Fp(y,w,Bv,Wv):Fp(y,w,{},Gv),M.splice(w,0,y),$s(M[w],w)}n.addSeries=ml;function gl(y){if(M.splice(y,1),rt){Me.values.splice(y,1),nt.splice(y,1);let w=xe.splice(y,1)[0];Gt(null,w.firstChild),w.remove()}et&&(_e.splice(y,1),Cn.splice(y,1)[0].remove(),Ki.splice(y,1),yi.splice(y,1)),yn("delSeries",y)}n.delSeries=gl;let ji=[!1,!1,!1,!1];function nd(y,w){if(y._show=y.show,y.show){let P=y.side%2,k=_[y.scale];k==null&&(y.scale=P?M[1].scale:R,k=_[y.scale]);let H=k.time;y.size=mt(y.size),y.space=mt(y.space),y.rotate=mt(y.rotate),Gs(y.incrs)&&y.incrs.forEach(se=>{!Ws.has(se)&&Ws.set(se,r_(se))}),y.incrs=mt(y.incrs||(k.distr==2?MR:H?p==1?TR:RR:Ir)),y.splits=mt(y.splits||(H&&k.distr==1?Z:k.distr==3?Lp:k.distr==4?XR:$R)),y.stroke=mt(y.stroke),y.grid.stroke=mt(y.grid.stroke),y.ticks.stroke=mt(y.ticks.stroke),y.border.stroke=mt(y.border.stroke);let Y=y.values;y.values=Gs(Y)&&!Gs(Y[0])?mt(Y):H?Gs(Y)?Nv(q,Dv(Y,Q)):Pv(Y)?IR(q,Y):Y||ae:Y||WR,y.filter=mt(y.filter||(k.distr>=3&&k.log==10?ZR:k.distr==3&&k.log==2?KR:i_)),y.font=Kv(y.font),y.labelFont=Kv(y.labelFont),y._size=y.size(n,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(ji[w]=!0,y._el=fi(kA,d))}}function Xs(y,w,P,k){let[H,Y,se,ce]=P,ge=w%2,Re=0;return ge==0&&(ce||Y)&&(Re=w==0&&!H||w==2&&!se?hn(Ov.size/3):0),ge==1&&(H||se)&&(Re=w==1&&!Y||w==3&&!ce?hn(Hv.size/2):0),Re}let yl=n.padding=(i.padding||[Xs,Xs,Xs,Xs]).map(y=>mt(bt(y,Xs))),ki=n._padding=yl.map((y,w)=>y(n,w,ji,0)),rn,E=null,G=null,J=s==1?M[0].idxs:null,K=null,W=!1;function pe(y,w){if(e=y??[],n.data=n._data=e,s==2){rn=0;for(let P=1;P<M.length;P++)rn+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),K=e[0],rn=K.length;let P=e;if(B==2){P=e.slice();let k=P[0]=Array(rn);for(let H=0;H<rn;H++)k[H]=H}n._data=e=P}if(Ur(!0),yn("setData"),B==2&&(Qe=!0),w!==!1){let P=C;P.auto(n,W)?Se():bs(R,P.min,P.max),z=z||ve.left>=0,me=!0,Or()}}n.setData=pe;function Se(){W=!0;let y,w;s==1&&(rn>0?(E=J[0]=0,G=J[1]=rn-1,y=e[0][E],w=e[0][G],B==2?(y=E,w=G):y==w&&(B==3?[y,w]=Tu(y,y,C.log,!1):B==4?[y,w]=zp(y,y,C.log,!1):C.time?w=y+hn(86400/p):[y,w]=wu(y,w,Hp,!0))):(E=J[0]=y=null,G=J[1]=w=null)),bs(R,y,w)}let Ne,Ae,Ye,Ze,Ge,lt,_t,Ot,Rt,ot;function qe(y,w,P,k,H,Y){y??=fv,P??=Gp,k??="butt",H??=fv,Y??="round",y!=Ne&&(u.strokeStyle=Ne=y),H!=Ae&&(u.fillStyle=Ae=H),w!=Ye&&(u.lineWidth=Ye=w),Y!=Ge&&(u.lineJoin=Ge=Y),k!=lt&&(u.lineCap=lt=k),P!=Ze&&u.setLineDash(Ze=P)}function Bt(y,w,P,k){w!=Ae&&(u.fillStyle=Ae=w),y!=_t&&(u.font=_t=y),P!=Ot&&(u.textAlign=Ot=P),k!=Rt&&(u.textBaseline=Rt=k)}function pt(y,w,P,k,H=0){if(k.length>0&&y.auto(n,W)&&(w==null||w.min==null)){let Y=bt(E,0),se=bt(G,k.length-1),ce=P.min==null?ZA(k,Y,se,H,y.distr==3):[P.min,P.max];y.min=Ii(y.min,P.min=ce[0]),y.max=Bn(y.max,P.max=ce[1])}}let Sn={min:null,max:null};function vs(){for(let k in _){let H=_[k];X[k]==null&&(H.min==null||X[R]!=null&&H.auto(n,W))&&(X[k]=Sn)}for(let k in _){let H=_[k];X[k]==null&&H.from!=null&&X[H.from]!=null&&(X[k]=Sn)}X[R]!=null&&Ur(!0);let y={};for(let k in X){let H=X[k];if(H!=null){let Y=y[k]=Bo(_[k],sR);if(H.min!=null)sn(Y,H);else if(k!=R||s==2)if(rn==0&&Y.from==null){let se=Y.range(n,null,null,k);Y.min=se[0],Y.max=se[1]}else Y.min=Nt,Y.max=-Nt}}if(rn>0){M.forEach((k,H)=>{if(s==1){let Y=k.scale,se=X[Y];if(se==null)return;let ce=y[Y];if(H==0){let ge=ce.range(n,ce.min,ce.max,Y);ce.min=ge[0],ce.max=ge[1],E=Pi(ce.min,e[0]),G=Pi(ce.max,e[0]),G-E>1&&(e[0][E]<ce.min&&E++,e[0][G]>ce.max&&G--),k.min=K[E],k.max=K[G]}else k.show&&k.auto&&pt(ce,se,k,e[H],k.sorted);k.idxs[0]=E,k.idxs[1]=G}else if(H>0&&k.show&&k.auto){let[Y,se]=k.facets,ce=Y.scale,ge=se.scale,[Re,Pe]=e[H],Fe=y[ce],st=y[ge];Fe!=null&&pt(Fe,X[ce],Y,Re,Y.sorted),st!=null&&pt(st,X[ge],se,Pe,se.sorted),k.min=se.min,k.max=se.max}});for(let k in y){let H=y[k],Y=X[k];if(H.from==null&&(Y==null||Y.min==null)){let se=H.range(n,H.min==Nt?null:H.min,H.max==-Nt?null:H.max,k);H.min=se[0],H.max=se[1]}}}for(let k in y){let H=y[k];if(H.from!=null){let Y=y[H.from];if(Y.min==null)H.min=H.max=null;else{let se=H.range(n,Y.min,Y.max,k);H.min=se[0],H.max=se[1]}}}let w={},P=!1;for(let k in y){let H=y[k],Y=_[k];if(Y.min!=H.min||Y.max!=H.max){Y.min=H.min,Y.max=H.max;let se=Y.distr;Y._min=se==3?gs(Y.min):se==4?Mp(Y.min,Y.asinh):se==100?Y.fwd(Y.min):Y.min,Y._max=se==3?gs(Y.max):se==4?Mp(Y.max,Y.asinh):se==100?Y.fwd(Y.max):Y.max,w[k]=P=!0}}if(P){M.forEach((k,H)=>{s==2?H>0&&w.y&&(k._paths=null):w[k.scale]&&(k._paths=null)});for(let k in w)Qe=!0,yn("setScale",k);et&&ve.left>=0&&(z=me=!0)}for(let k in X)X[k]=null}function Pn(y){let w=Ip(E-1,0,rn-1),P=Ip(G+1,0,rn-1);for(;y[w]==null&&w>0;)w--;for(;y[P]==null&&P<rn-1;)P++;return[w,P]}function qs(){if(rn>0){let y=M.some(w=>w._focus)&&ot!=Gn.alpha;y&&(u.globalAlpha=ot=Gn.alpha),M.forEach((w,P)=>{if(P>0&&w.show&&(zt(P,!1),zt(P,!0),w._paths==null)){let k=ot;ot!=w.alpha&&(u.globalAlpha=ot=w.alpha);let H=s==2?[0,e[P][0].length-1]:Pn(e[P]);w._paths=w.paths(n,P,H[0],H[1]),ot!=k&&(u.globalAlpha=ot=k)}}),M.forEach((w,P)=>{if(P>0&&w.show){let k=ot;ot!=w.alpha&&(u.globalAlpha=ot=w.alpha),w._paths!=null&&In(P,!1);{let H=w._paths!=null?w._paths.gaps:null,Y=w.points.show(n,P,E,G,H),se=w.points.filter(n,P,Y,H);(Y||se)&&(w.points._paths=w.points.paths(n,P,E,G,se),In(P,!0))}ot!=k&&(u.globalAlpha=ot=k),yn("drawSeries",P)}}),y&&(u.globalAlpha=ot=1)}}function zt(y,w){let P=w?M[y].points:M[y];P._stroke=P.stroke(n,y),P._fill=P.fill(n,y)}function In(y,w){let P=w?M[y].points:M[y],{stroke:k,fill:H,clip:Y,flags:se,_stroke:ce=P._stroke,_fill:ge=P._fill,_width:Re=P.width}=P._paths;Re=Ft(Re*St,3);let Pe=null,Fe=Re%2/2;w&&ge==null&&(ge=Re>0?"#fff":ce);let st=P.pxAlign==1&&Fe>0;if(st&&u.translate(Fe,Fe),!w){let Mt=Ce-Re/2,xt=oe-Re/2,ut=ye+Re,Je=He+Re;Pe=new Path2D,Pe.rect(Mt,xt,ut,Je)}w?pn(ce,Re,P.dash,P.cap,ge,k,H,se,Y):Hn(y,ce,Re,P.dash,P.cap,ge,k,H,se,Pe,Y),st&&u.translate(-Fe,-Fe)}function Hn(y,w,P,k,H,Y,se,ce,ge,Re,Pe){let Fe=!1;ge!=0&&I.forEach((st,Mt)=>{if(st.series[0]==y){let xt=M[st.series[1]],ut=e[st.series[1]],Je=(xt._paths||cl).band;Gs(Je)&&(Je=st.dir==1?Je[0]:Je[1]);let We,Xt=null;xt.show&&Je&&jA(ut,E,G)?(Xt=st.fill(n,Mt)||Y,We=xt._paths.clip):Je=null,pn(w,P,k,H,Xt,se,ce,ge,Re,Pe,We,Je),Fe=!0}}),Fe||pn(w,P,k,H,Y,se,ce,ge,Re,Pe)}let fn=zo|Dp;function pn(y,w,P,k,H,Y,se,ce,ge,Re,Pe,Fe){qe(y,w,P,k,H),(ge||Re||Fe)&&(u.save(),ge&&u.clip(ge),Re&&u.clip(Re)),Fe?(ce&fn)==fn?(u.clip(Fe),Pe&&u.clip(Pe),si(H,se),_s(y,Y,w)):ce&Dp?(si(H,se),u.clip(Fe),_s(y,Y,w)):ce&zo&&(u.save(),u.clip(Fe),Pe&&u.clip(Pe),si(H,se),u.restore(),_s(y,Y,w)):(si(H,se),_s(y,Y,w)),(ge||Re||Fe)&&u.restore()}function _s(y,w,P){P>0&&(w instanceof Map?w.forEach((k,H)=>{u.strokeStyle=Ne=H,u.stroke(k)}):w!=null&&y&&u.stroke(w))}function si(y,w){w instanceof Map?w.forEach((P,k)=>{u.fillStyle=Ae=k,u.fill(P)}):w!=null&&y&&u.fill(w)}function Nx(y,w,P,k){let H=b[y],Y;if(k<=0)Y=[0,0];else{let se=H._space=H.space(n,y,w,P,k),ce=H._incrs=H.incrs(n,y,w,P,k,se);Y=vC(w,P,ce,k,se)}return H._found=Y}function id(y,w,P,k,H,Y,se,ce,ge,Re){let Pe=se%2/2;v==1&&u.translate(Pe,Pe),qe(ce,se,ge,Re,ce),u.beginPath();let Fe,st,Mt,xt,ut=H+(k==0||k==3?-Y:Y);P==0?(st=H,xt=ut):(Fe=H,Mt=ut);for(let Je=0;Je<y.length;Je++)w[Je]!=null&&(P==0?Fe=Mt=y[Je]:st=xt=y[Je],u.moveTo(Fe,st),u.lineTo(Mt,xt));u.stroke(),v==1&&u.translate(-Pe,-Pe)}function Fx(y){let w=!0;return b.forEach((P,k)=>{if(!P.show)return;let H=_[P.scale];if(H.min==null){P._show&&(w=!1,P._show=!1,Ur(!1));return}else P._show||(w=!1,P._show=!0,Ur(!1));let Y=P.side,se=Y%2,{min:ce,max:ge}=H,[Re,Pe]=Nx(k,ce,ge,se==0?x:U);if(Pe==0)return;let Fe=H.distr==2,st=P._splits=P.splits(n,k,ce,ge,Re,Pe,Fe),Mt=H.distr==2?st.map(We=>K[We]):st,xt=H.distr==2?K[st[1]]-K[st[0]]:Re,ut=P._values=P.values(n,P.filter(n,Mt,k,Pe,xt),k,Pe,xt);P._rotate=Y==2?P.rotate(n,ut,k,Pe):0;let Je=P._size;P._size=pi(P.size(n,ut,k,y)),Je!=null&&P._size!=Je&&(w=!1)}),w}function Ux(y){let w=!0;return yl.forEach((P,k)=>{let H=P(n,k,ji,y);H!=ki[k]&&(w=!1),ki[k]=H}),w}function Ox(){for(let y=0;y<b.length;y++){let w=b[y];if(!w.show||!w._show)continue;let P=w.side,k=P%2,H,Y,se=w.stroke(n,y),ce=P==0||P==3?-1:1,[ge,Re]=w._found;if(w.label!=null){let kn=w.labelGap*ce,Xn=hn((w._lpos+kn)*St);Bt(w.labelFont[0],se,"center",P==2?"top":dv),u.save(),k==1?(H=Y=0,u.translate(Xn,hn(oe+He/2)),u.rotate((P==3?-xu:xu)/2)):(H=hn(Ce+ye/2),Y=Xn);let Ks=t_(w.label)?w.label(n,y,ge,Re):w.label;u.fillText(Ks,H,Y),u.restore()}if(Re==0)continue;let Pe=_[w.scale],Fe=k==0?ye:He,st=k==0?Ce:oe,Mt=w._splits,xt=Pe.distr==2?Mt.map(kn=>K[kn]):Mt,ut=Pe.distr==2?K[Mt[1]]-K[Mt[0]]:ge,Je=w.ticks,We=w.border,Xt=Je.show?Je.size:0,Jt=hn(Xt*St),vn=hn((w.alignTo==2?w._size-Xt-w.gap:w.gap)*St),Lt=w._rotate*-xu/180,Qt=m(w._pos*St),Wn=(Jt+vn)*ce,Ln=Qt+Wn;Y=k==0?Ln:0,H=k==1?Ln:0;let ri=w.font[0],vi=w.align==1?Do:w.align==2?xp:Lt>0?Do:Lt<0?xp:k==0?"center":P==3?xp:Do,Fi=Lt||k==1?"middle":P==2?"top":dv;Bt(ri,se,vi,Fi);let $n=w.font[1]*w.lineGap,oi=Mt.map(kn=>m(a(kn,Pe,Fe,st))),_i=w._values;for(let kn=0;kn<_i.length;kn++){let Xn=_i[kn];if(Xn!=null){k==0?H=oi[kn]:Y=oi[kn],Xn=""+Xn;let Ks=Xn.indexOf(`
`)==-1?[Xn]:Xn.split(/\n/gm);for(let Dn=0;Dn<Ks.length;Dn++){let Im=Ks[Dn];Lt?(u.save(),u.translate(H,Y+Dn*$n),u.rotate(Lt),u.fillText(Im,0,0),u.restore()):u.fillText(Im,H,Y+Dn*$n)}}}Je.show&&id(oi,Je.filter(n,xt,y,Re,ut),k,P,Qt,Jt,Ft(Je.width*St,3),Je.stroke(n,y),Je.dash,Je.cap);let Ui=w.grid;Ui.show&&id(oi,Ui.filter(n,xt,y,Re,ut),k,k==0?2:1,k==0?oe:Ce,k==0?He:ye,Ft(Ui.width*St,3),Ui.stroke(n,y),Ui.dash,Ui.cap),We.show&&id([Qt],[1],k==0?1:0,k==0?1:2,k==1?oe:Ce,k==1?He:ye,Ft(We.width*St,3),We.stroke(n,y),We.dash,We.cap)}yn("drawAxes")}function Ur(y){M.forEach((w,P)=>{P>0&&(w._paths=null,y&&(s==1?(w.min=null,w.max=null):w.facets.forEach(k=>{k.min=null,k.max=null})))})}let vl=!1,sd=!1,Xo=[];function Bx(){sd=!1;for(let y=0;y<Xo.length;y++)yn(...Xo[y]);Xo.length=0}function Or(){vl||(uR(fm),vl=!0)}function zx(y,w=!1){vl=!0,sd=w,y(n),fm(),w&&Xo.length>0&&queueMicrotask(Bx)}n.batch=zx;function fm(){if(ze&&(vs(),ze=!1),Qe&&(Be(),Qe=!1),be){if(Yt(f,Do,j),Yt(f,"top",ie),Yt(f,rl,x),Yt(f,ol,U),Yt(g,Do,j),Yt(g,"top",ie),Yt(g,rl,x),Yt(g,ol,U),Yt(d,rl,wt),Yt(d,ol,L),h.width=hn(wt*St),h.height=hn(L*St),b.forEach(({_el:y,_show:w,_size:P,_pos:k,side:H})=>{if(y!=null)if(w){let Y=H===3||H===0?P:0,se=H%2==1;Yt(y,se?"left":"top",k-Y),Yt(y,se?"width":"height",P),Yt(y,se?"top":"left",se?ie:j),Yt(y,se?"height":"width",se?U:x),Cp(y,Lr)}else ei(y,Lr)}),Ne=Ae=Ye=Ge=lt=_t=Ot=Rt=Ze=null,ot=1,Zo(!0),j!=te||ie!=Oe||x!=de||U!=De){Ur(!1);let y=x/de,w=U/De;if(et&&!z&&ve.left>=0){ve.left*=y,ve.top*=w,Br&&Zi(Br,hn(ve.left),0,x,U),zr&&Zi(zr,0,hn(ve.top),x,U);for(let P=0;P<Cn.length;P++){let k=Cn[P];k!=null&&(Ki[P]*=y,yi[P]*=w,Zi(k,pi(Ki[P]),pi(yi[P]),x,U))}}if($t.show&&!fe&&$t.left>=0&&$t.width>0){$t.left*=y,$t.width*=y,$t.top*=w,$t.height*=w;for(let P in hd)Yt(Gr,P,$t[P])}te=j,Oe=ie,de=x,De=U}yn("setSize"),be=!1}wt>0&&L>0&&(u.clearRect(0,0,h.width,h.height),yn("drawClear"),N.forEach(y=>y()),yn("draw")),$t.show&&fe&&(_l($t),fe=!1),et&&z&&(Zs(null,!0,!1),z=!1),Me.show&&Me.live&&me&&(ld(),me=!1),l||(l=!0,n.status=1,yn("ready")),W=!1,vl=!1}n.redraw=(y,w)=>{Qe=w||!1,y!==!1?bs(R,C.min,C.max):Or()};function rd(y,w){let P=_[y];if(P.from==null){if(rn==0){let k=P.range(n,w.min,w.max,y);w.min=k[0],w.max=k[1]}if(w.min>w.max){let k=w.min;w.min=w.max,w.max=k}if(rn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==R&&P.distr==2&&rn>0&&(w.min=Pi(w.min,e[0]),w.max=Pi(w.max,e[0]),w.min==w.max&&w.max++),X[y]=w,ze=!0,Or()}}n.setScale=rd;let od,ad,Br,zr,pm,mm,Hr,Vr,gm,ym,Wt,Zt,xs=!1,wn=ve.drag,mn=wn.x,gn=wn.y;et&&(ve.x&&(od=fi(NA,g)),ve.y&&(ad=fi(FA,g)),C.ori==0?(Br=od,zr=ad):(Br=ad,zr=od),Wt=ve.left,Zt=ve.top);let $t=n.select=sn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Gr=$t.show?fi(DA,$t.over?g:f):null;function _l(y,w){if($t.show){for(let P in y)$t[P]=y[P],P in hd&&Yt(Gr,P,y[P]);w!==!1&&yn("setSelect")}}n.setSelect=_l;function Hx(y){if(M[y].show)rt&&Cp(xe[y],Lr);else if(rt&&ei(xe[y],Lr),et){let P=Li?Cn[0]:Cn[y];P!=null&&Zi(P,-10,-10,x,U)}}function bs(y,w,P){rd(y,{min:w,max:P})}function Di(y,w,P,k){w.focus!=null&&Xx(y),w.show!=null&&M.forEach((H,Y)=>{Y>0&&(y==Y||y==null)&&(H.show=w.show,Hx(Y),s==2?(bs(H.facets[0].scale,null,null),bs(H.facets[1].scale,null,null)):bs(H.scale,null,null),Or())}),P!==!1&&yn("setSeries",y,w),k&&Ko("setSeries",n,y,w)}n.setSeries=Di;function Vx(y,w){sn(I[y],w)}function Gx(y,w){y.fill=mt(y.fill||null),y.dir=bt(y.dir,-1),w=w??I.length,I.splice(w,0,y)}function Wx(y){y==null?I.length=0:I.splice(y,1)}n.addBand=Gx,n.setBand=Vx,n.delBand=Wx;function $x(y,w){M[y].alpha=w,et&&Cn[y]!=null&&(Cn[y].style.opacity=w),rt&&xe[y]&&(xe[y].style.opacity=w)}let Ji,ws,Ys,Wr={focus:!0};function Xx(y){if(y!=Ys){let w=y==null,P=Gn.alpha!=1;M.forEach((k,H)=>{if(s==1||H>0){let Y=w||H==0||H==y;k._focus=w?null:Y,P&&$x(H,Y?1:Gn.alpha)}}),Ys=y,P&&Or()}}rt&&zn&&$e(gv,ne,y=>{ve._lock||(bn(y),Ys!=null&&Di(null,Wr,!0,tn.setSeries))});function Ni(y,w,P){let k=_[w];P&&(y=y/St-(k.ori==1?ie:j));let H=x;k.ori==1&&(H=U,y=H-y),k.dir==-1&&(y=H-y);let Y=k._min,se=k._max,ce=y/H,ge=Y+(se-Y)*ce,Re=k.distr;return Re==3?Uo(10,ge):Re==4?QA(ge,k.asinh):Re==100?k.bwd(ge):ge}function qx(y,w){let P=Ni(y,R,w);return Pi(P,e[0],E,G)}n.valToIdx=y=>Pi(y,e[0]),n.posToIdx=qx,n.posToVal=Ni,n.valToPos=(y,w,P)=>_[w].ori==0?r(y,_[w],P?ye:x,P?Ce:0):o(y,_[w],P?He:U,P?oe:0),n.setCursor=(y,w,P)=>{Wt=y.left,Zt=y.top,Zs(null,w,P)};function vm(y,w){Yt(Gr,Do,$t.left=y),Yt(Gr,rl,$t.width=w)}function _m(y,w){Yt(Gr,"top",$t.top=y),Yt(Gr,ol,$t.height=w)}let qo=C.ori==0?vm:_m,Yo=C.ori==1?vm:_m;function Yx(){if(rt&&Me.live)for(let y=s==2?1:0;y<M.length;y++){if(y==0&&F)continue;let w=Me.values[y],P=0;for(let k in w)nt[y][P++].firstChild.nodeValue=w[k]}}function ld(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((P,k)=>{_e[k]=P}):iR(y.idx)||_e.fill(y.idx),Me.idx=_e[0]),rt&&Me.live){for(let P=0;P<M.length;P++)(P>0||s==1&&!F)&&Zx(P,_e[P]);Yx()}me=!1,w!==!1&&yn("setLegend")}n.setLegend=ld;function Zx(y,w){let P=M[y],k=y==0&&B==2?K:e[y],H;F?H=P.values(n,y,w)??gt:(H=P.value(n,w==null?null:k[w],y,w),H=H==null?gt:{_:H}),Me.values[y]=H}function Zs(y,w,P){gm=Wt,ym=Zt,[Wt,Zt]=ve.move(n,Wt,Zt),ve.left=Wt,ve.top=Zt,et&&(Br&&Zi(Br,hn(Wt),0,x,U),zr&&Zi(zr,0,hn(Zt),x,U));let k,H=E>G;Ji=Nt,ws=null;let Y=C.ori==0?x:U,se=C.ori==1?x:U;if(Wt<0||rn==0||H){k=ve.idx=null;for(let ce=0;ce<M.length;ce++){let ge=Cn[ce];ge!=null&&Zi(ge,-10,-10,x,U)}zn&&Di(null,Wr,!0,y==null&&tn.setSeries),Me.live&&(_e.fill(k),me=!0)}else{let ce,ge,Re;s==1&&(ce=C.ori==0?Wt:Zt,ge=Ni(ce,R),k=ve.idx=Pi(ge,e[0],E,G),Re=V(e[0][k],C,Y,0));let Pe=-10,Fe=-10,st=0,Mt=0,xt=!0,ut="",Je="";for(let We=s==2?1:0;We<M.length;We++){let Xt=M[We],Jt=_e[We],vn=Jt==null?null:s==1?e[We][Jt]:e[We][1][Jt],Lt=ve.dataIdx(n,We,k,ge),Qt=Lt==null?null:s==1?e[We][Lt]:e[We][1][Lt];if(me=me||Qt!=vn||Lt!=Jt,_e[We]=Lt,We>0&&Xt.show){let Wn=Lt==null?-10:Lt==k?Re:V(s==1?e[0][Lt]:e[We][0][Lt],C,Y,0),Ln=Qt==null?-10:$(Qt,s==1?_[Xt.scale]:_[Xt.facets[1].scale],se,0);if(zn&&Qt!=null){let ri=C.ori==1?Wt:Zt,vi=un(Gn.dist(n,We,Lt,Ln,ri));if(vi<Ji){let Fi=Gn.bias;if(Fi!=0){let $n=Ni(ri,Xt.scale),oi=Qt>=0?1:-1,_i=$n>=0?1:-1;_i==oi&&(_i==1?Fi==1?Qt>=$n:Qt<=$n:Fi==1?Qt<=$n:Qt>=$n)&&(Ji=vi,ws=We)}else Ji=vi,ws=We}}if(me||Li){let ri,vi;C.ori==0?(ri=Wn,vi=Ln):(ri=Ln,vi=Wn);let Fi,$n,oi,_i,Ui,kn,Xn=!0,Ks=Dt.bbox;if(Ks!=null){Xn=!1;let Dn=Ks(n,We);oi=Dn.left,_i=Dn.top,Fi=Dn.width,$n=Dn.height}else oi=ri,_i=vi,Fi=$n=Dt.size(n,We);if(kn=Dt.fill(n,We),Ui=Dt.stroke(n,We),Li)We==ws&&Ji<=Gn.prox&&(Pe=oi,Fe=_i,st=Fi,Mt=$n,xt=Xn,ut=kn,Je=Ui);else{let Dn=Cn[We];Dn!=null&&(Ki[We]=oi,yi[We]=_i,Mv(Dn,Fi,$n,Xn),bv(Dn,kn,Ui),Zi(Dn,pi(oi),pi(_i),x,U))}}}}if(Li){let We=Gn.prox,Xt=Ys==null?Ji<=We:Ji>We||ws!=Ys;if(me||Xt){let Jt=Cn[0];Jt!=null&&(Ki[0]=Pe,yi[0]=Fe,Mv(Jt,st,Mt,xt),bv(Jt,ut,Je),Zi(Jt,pi(Pe),pi(Fe),x,U))}}}if($t.show&&xs)if(y!=null){let[ce,ge]=tn.scales,[Re,Pe]=tn.match,[Fe,st]=y.cursor.sync.scales,Mt=y.cursor.drag;if(mn=Mt._x,gn=Mt._y,mn||gn){let{left:xt,top:ut,width:Je,height:We}=y.select,Xt=y.scales[Fe].ori,Jt=y.posToVal,vn,Lt,Qt,Wn,Ln,ri=ce!=null&&Re(ce,Fe),vi=ge!=null&&Pe(ge,st);ri&&mn?(Xt==0?(vn=xt,Lt=Je):(vn=ut,Lt=We),Qt=_[ce],Wn=V(Jt(vn,Fe),Qt,Y,0),Ln=V(Jt(vn+Lt,Fe),Qt,Y,0),qo(Ii(Wn,Ln),un(Ln-Wn))):qo(0,Y),vi&&gn?(Xt==1?(vn=xt,Lt=Je):(vn=ut,Lt=We),Qt=_[ge],Wn=$(Jt(vn,st),Qt,se,0),Ln=$(Jt(vn+Lt,st),Qt,se,0),Yo(Ii(Wn,Ln),un(Ln-Wn))):Yo(0,se)}else ud()}else{let ce=un(gm-pm),ge=un(ym-mm);if(C.ori==1){let st=ce;ce=ge,ge=st}mn=wn.x&&ce>=wn.dist,gn=wn.y&&ge>=wn.dist;let Re=wn.uni;Re!=null?mn&&gn&&(mn=ce>=Re,gn=ge>=Re,!mn&&!gn&&(ge>ce?gn=!0:mn=!0)):wn.x&&wn.y&&(mn||gn)&&(mn=gn=!0);let Pe,Fe;mn&&(C.ori==0?(Pe=Hr,Fe=Wt):(Pe=Vr,Fe=Zt),qo(Ii(Pe,Fe),un(Fe-Pe)),gn||Yo(0,se)),gn&&(C.ori==1?(Pe=Hr,Fe=Wt):(Pe=Vr,Fe=Zt),Yo(Ii(Pe,Fe),un(Fe-Pe)),mn||qo(0,Y)),!mn&&!gn&&(qo(0,0),Yo(0,0))}if(wn._x=mn,wn._y=gn,y==null){if(P){if(Pm!=null){let[ce,ge]=tn.scales;tn.values[0]=ce!=null?Ni(C.ori==0?Wt:Zt,ce):null,tn.values[1]=ge!=null?Ni(C.ori==1?Wt:Zt,ge):null}Ko(bp,n,Wt,Zt,x,U,k)}if(zn){let ce=P&&tn.setSeries,ge=Gn.prox;Ys==null?Ji<=ge&&Di(ws,Wr,!0,ce):Ji>ge?Di(null,Wr,!0,ce):ws!=Ys&&Di(ws,Wr,!0,ce)}}me&&(Me.idx=k,ld()),w!==!1&&yn("setCursor")}let Ms=null;Object.defineProperty(n,"rect",{get(){return Ms==null&&Zo(!1),Ms}});function Zo(y=!1){y?Ms=null:(Ms=g.getBoundingClientRect(),yn("syncRect",Ms))}function xm(y,w,P,k,H,Y,se){ve._lock||xs&&y!=null&&y.movementX==0&&y.movementY==0||(cd(y,w,P,k,H,Y,se,!1,y!=null),y!=null?Zs(null,!0,!0):Zs(w,!0,!1))}function cd(y,w,P,k,H,Y,se,ce,ge){if(Ms==null&&Zo(!1),bn(y),y!=null)P=y.clientX-Ms.left,k=y.clientY-Ms.top;else{if(P<0||k<0){Wt=-10,Zt=-10;return}let[Re,Pe]=tn.scales,Fe=w.cursor.sync,[st,Mt]=Fe.values,[xt,ut]=Fe.scales,[Je,We]=tn.match,Xt=w.axes[0].side%2==1,Jt=C.ori==0?x:U,vn=C.ori==1?x:U,Lt=Xt?Y:H,Qt=Xt?H:Y,Wn=Xt?k:P,Ln=Xt?P:k;if(xt!=null?P=Je(Re,xt)?a(st,_[Re],Jt,0):-10:P=Jt*(Wn/Lt),ut!=null?k=We(Pe,ut)?a(Mt,_[Pe],vn,0):-10:k=vn*(Ln/Qt),C.ori==1){let ri=P;P=k,k=ri}}ge&&(w==null||w.cursor.event.type==bp)&&((P<=1||P>=x-1)&&(P=Pr(P,x)),(k<=1||k>=U-1)&&(k=Pr(k,U))),ce?(pm=P,mm=k,[Hr,Vr]=ve.move(n,P,k)):(Wt=P,Zt=k)}let hd={width:0,height:0,left:0,top:0};function ud(){_l(hd,!1)}let bm,wm,Mm,Sm;function Tm(y,w,P,k,H,Y,se){xs=!0,mn=gn=wn._x=wn._y=!1,cd(y,w,P,k,H,Y,se,!0,!1),y!=null&&($e(wp,Ap,Em,!1),Ko(pv,n,Hr,Vr,x,U,null));let{left:ce,top:ge,width:Re,height:Pe}=$t;bm=ce,wm=ge,Mm=Re,Sm=Pe}function Em(y,w,P,k,H,Y,se){xs=wn._x=wn._y=!1,cd(y,w,P,k,H,Y,se,!1,!0);let{left:ce,top:ge,width:Re,height:Pe}=$t,Fe=Re>0||Pe>0,st=bm!=ce||wm!=ge||Mm!=Re||Sm!=Pe;if(Fe&&st&&_l($t),wn.setScale&&Fe&&st){let Mt=ce,xt=Re,ut=ge,Je=Pe;if(C.ori==1&&(Mt=ge,xt=Pe,ut=ce,Je=Re),mn&&bs(R,Ni(Mt,R),Ni(Mt+xt,R)),gn)for(let We in _){let Xt=_[We];We!=R&&Xt.from==null&&Xt.min!=Nt&&bs(We,Ni(ut+Je,We),Ni(ut,We))}ud()}else ve.lock&&(ve._lock=!ve._lock,Zs(w,!0,y!=null));y!=null&&(Gt(wp,Ap),Ko(wp,n,Wt,Zt,x,U,null))}function Kx(y,w,P,k,H,Y,se){if(ve._lock)return;bn(y);let ce=xs;if(xs){let ge=!0,Re=!0,Pe=10,Fe,st;C.ori==0?(Fe=mn,st=gn):(Fe=gn,st=mn),Fe&&st&&(ge=Wt<=Pe||Wt>=x-Pe,Re=Zt<=Pe||Zt>=U-Pe),Fe&&ge&&(Wt=Wt<Hr?0:x),st&&Re&&(Zt=Zt<Vr?0:U),Zs(null,!0,!0),xs=!1}Wt=-10,Zt=-10,_e.fill(null),Zs(null,!0,!0),ce&&(xs=ce)}function Am(y,w,P,k,H,Y,se){ve._lock||(bn(y),Se(),ud(),y!=null&&Ko(yv,n,Wt,Zt,x,U,null))}function Rm(){b.forEach(_C),Le(n.width,n.height,!0)}kr(bu,Fo,Rm);let $r={};$r.mousedown=Tm,$r.mousemove=xm,$r.mouseup=Em,$r.dblclick=Am,$r.setSeries=(y,w,P,k)=>{let H=tn.match[2];P=H(n,w,P),P!=-1&&Di(P,k,!0,!1)},et&&($e(pv,g,Tm),$e(bp,g,xm),$e(mv,g,y=>{bn(y),Zo(!1)}),$e(gv,g,Kx),$e(yv,g,Am),Np.add(n),n.syncRect=Zo);let xl=n.hooks=i.hooks||{};function yn(y,w,P){sd?Xo.push([y,w,P]):y in xl&&xl[y].forEach(k=>{k.call(null,n,w,P)})}(i.plugins||[]).forEach(y=>{for(let w in y.hooks)xl[w]=(xl[w]||[]).concat(y.hooks[w])});let Cm=(y,w,P)=>P,tn=sn({key:null,setSeries:!1,filters:{pub:Rv,sub:Rv},scales:[R,M[1]?M[1].scale:null],match:[Cv,Cv,Cm],values:[null,null]},ve.sync);tn.match.length==2&&tn.match.push(Cm),ve.sync=tn;let Pm=tn.key,dd=T_(Pm);function Ko(y,w,P,k,H,Y,se){tn.filters.pub(y,w,P,k,H,Y,se)&&dd.pub(y,w,P,k,H,Y,se)}dd.sub(n);function jx(y,w,P,k,H,Y,se){tn.filters.sub(y,w,P,k,H,Y,se)&&$r[y](null,w,P,k,H,Y,se)}n.pub=jx;function Jx(){dd.unsub(n),Np.delete(n),Ie.clear(),Pp(bu,Fo,Rm),c.remove(),ne?.remove(),yn("destroy")}n.destroy=Jx;function fd(){yn("init",i,e),pe(e||i.data,!1),X[R]?rd(R,X[R]):Se(),fe=$t.show&&($t.width>0||$t.height>0),z=me=!0,Le(i.width,i.height)}return M.forEach($s),b.forEach(nd),t?t instanceof HTMLElement?(t.appendChild(c),fd()):t(n,fd):fd(),n}dn.assign=sn;dn.fmtNum=Vp;dn.rangeNum=wu;dn.rangeLog=Tu;dn.rangeAsinh=zp;dn.orient=Nr;dn.pxRatio=St;dn.join=hR;dn.fmtDate=Wp,dn.tzDate=bR;dn.sync=T_;{dn.addGap=iC,dn.clipGaps=Ru;let i=dn.paths={points:I_};i.linear=k_,i.stepped=oC,i.bars=aC,i.spline=cC}var jp=60,xC=.35,Lu=class{names="";times_s=[];values=[];add(e,t){let n=e.map(({name:r})=>r).join();e.length>0&&n!==this.names&&this.begin(e,n);let s=this.times_s.at(-1);s!==void 0&&t<=s||e.length!==0&&(s!==void 0&&t-s>xC&&this.push((s+t)/2,[]),this.push(t,e),this.forget(t-jp))}of(e,t){let{measured:n=[],simulated:s=[],unit:r=""}=this.values[e]??{},{times:o}=ko(r),a=c=>c.map(h=>h===null?null:h*o),l=n.map((c,h)=>{let u=s[h]??null;return c===null||u===null?null:(r==="rad"?Ar(c-u):c-u)*o});return{times_s:this.times_s.map(c=>c-t),measured:a(n),simulated:a(s),difference:l}}begin(e,t){this.names=t,this.times_s=[],this.values=e.map(({unit:n})=>({measured:[],simulated:[],unit:n}))}push(e,t){let n=s=>s===void 0||Number.isNaN(s)?null:s;this.times_s.push(e);for(let[s,{measured:r,simulated:o}]of this.values.entries())r.push(n(t[s]?.measured)),o.push(n(t[s]?.simulated))}forget(e){let t=this.times_s.findIndex(n=>n>=e);if(!(t<=0))for(let n of[this.times_s,...this.values.flatMap(({measured:s,simulated:r})=>[s,r])])n.splice(0,t)}};var bC=200,U_={values:150,difference:110},wC=10,O_=i=>String(i).replace("-","−"),ku=class{box;title=A("h2",{id:"twin-plot-title"});now=A("p",{class:"plot-now"});panes=A("div");plots=[];unit;drawn_ms=-1/0;constructor(){let[e,t]=[A("b",{class:"measured"}),A("b",{class:"simulated"})];this.now.append(A("span",{class:"key measured"},"robot there, measured "),e,A("span",{class:"key simulated"},"simulated "),t),this.values={measured:e,simulated:t},this.box=A("figure",{class:"twin-plot","aria-labelledby":"twin-plot-title"},this.title,this.now,this.panes),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.makeAnew())}values;makeAnew(){for(let e of this.plots)e.destroy();this.panes.replaceChildren(),this.plots=[],this.drawn_ms=-1/0}draw(e,t,n,s){if(s-this.drawn_ms<bC||this.panes.clientWidth===0)return;this.drawn_ms=s;let{unit:r}=ko(e.unit);he(this.title,`${Cr(e.name)}, ${r}`),he(this.values.measured,Vs(e.measured,e.unit)),he(this.values.simulated,Vs(e.simulated,e.unit)),(this.plots.length===0||r!==this.unit)&&this.make(r);let{times_s:o,measured:a,simulated:l,difference:c}=n.of(t,s/1e3),h=e.limit>0?e.limit*ko(e.unit).times:null,u=f=>o.map(()=>f),d=this.panes.clientWidth;for(let f of this.plots)f.width!==d&&f.setSize({width:d,height:f.height});this.plots[0]?.setData([o,l,a]),this.plots[1]?.setData([o,c,u(h),u(h===null?null:-h)])}make(e){this.makeAnew(),this.unit=e;let t={label:"limit",colour:"--bad",dash:[4,4]};this.plots=[this.pane(U_.values,[{label:"simulated",colour:"--accent"},{label:"measured",colour:"--twin"}]),this.pane(U_.difference,[{label:"difference",colour:"--text"},t,t])],this.panes.children[1]?.before(A("p",{class:"note"},"Measured less simulated; dashed: the limit"))}pane(e,t){let n=getComputedStyle(this.box),s=o=>n.getPropertyValue(o),r={stroke:n.color,grid:{stroke:s("--line"),width:1},ticks:{stroke:s("--line"),width:1}};return new dn({width:Math.max(this.panes.clientWidth,200),height:e,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,range:(o,a)=>[Math.min(Math.max(a??0,-jp),-wC),0]}},axes:[{...r,size:30,values:(o,a)=>a.map(l=>`${O_(l)} s`)},{...r,size:44,values:(o,a)=>a.map(O_)}],series:[{},...t.map(o=>({stroke:s(o.colour),width:o.dash?1:1.75,...o.dash?{dash:o.dash}:{},points:{show:!1}}))]},[[],...t.map(()=>[])],this.panes)}};var B_=8,MC=1e3,SC=1500,z_=2,Du=class{constructor(e){this.choose=e;let t=A("thead",{},A("tr",{},...["channel","difference, RMS of 2 s","","limit"].map(s=>A("th",{scope:"col"},s)))),n=A("table",{class:"differences"},A("caption",{class:"hidden"},"Differences, the worst first"),t,this.body);this.more=ke("",()=>{this.all=!this.all,this.fold()},{id:"twin-all",class:"plain-more","aria-expanded":"false"}),this.box=A("div",{},n,this.more),n.addEventListener("pointermove",()=>this.pointed_ms=performance.now())}box;body=A("tbody");more;rows=new Map;order=[];sorted_ms=-1/0;pointed_ms=-1/0;all=!1;chosen;show(e,t){(e.length!==this.rows.size||e.some(({name:n})=>!this.rows.has(n)))&&this.begin(e);for(let n of e)this.fill(n);t-this.sorted_ms<MC||t-this.pointed_ms<SC||(this.sorted_ms=t,this.sort(il(e).map(({name:n})=>n)))}setChosen(e){if(e!==this.chosen){this.chosen=e;for(let[t,{name:n}]of this.rows)n.setAttribute("aria-pressed",String(t===e));this.fold()}}begin(e){this.rows.clear(),this.order=[];for(let{name:t}of e){let n=ke(Cr(t),()=>this.choose(t),{class:"channel","aria-pressed":String(t===this.chosen),title:"Plot it"}),s=A("span",{class:"bar"}),[r,o]=[A("td",{class:"number"}),A("td",{class:"number limit"})],a=A("tr",{"data-channel":t},A("th",{scope:"row"},n),A("td",{class:"bar-cell"},s),r,o);a.addEventListener("click",({target:l})=>l!==n&&this.choose(t)),this.rows.set(t,{row:a,name:n,bar:s,difference:r,limit:o})}this.sorted_ms=this.pointed_ms=-1/0}fill(e){let t=this.rows.get(e.name);if(!t)return;let n=nl(e),s=_p(e);t.row.classList.toggle("above",s),t.row.classList.toggle("chosen",e.name===this.chosen),t.row.classList.toggle("unknown",!Number.isFinite(e.difference)),t.bar.style.setProperty("--share",String(Math.min(Math.max(n||0,0),z_)/z_)),t.bar.classList.toggle("near",n>.7&&!s),t.bar.hidden=e.limit===0,he(t.difference,Vs(e.difference,e.unit)),he(t.limit,e.limit>0?Vs(e.limit,e.unit):"never")}sort(e){if(e.join()!==this.order.join()){let t=document.activeElement;this.order=[...e];for(let[n,s]of e.entries()){let r=this.rows.get(s)?.row;r&&this.body.children[n]!==r&&this.body.insertBefore(r,this.body.children[n]??null)}for(;this.body.childElementCount>e.length;)this.body.lastElementChild?.remove();t instanceof HTMLElement&&t!==document.activeElement&&this.body.contains(t)&&t.focus({preventScroll:!0})}this.fold()}fold(){for(let[e,t]of this.order.entries()){let n=this.rows.get(t)?.row;n&&(n.hidden=!this.all&&e>=B_&&t!==this.chosen&&!n.classList.contains("above"))}this.more.hidden=this.order.length<=B_,this.more.setAttribute("aria-expanded",String(this.all)),he(this.more,this.all?"Only the worst":`All ${this.order.length}`)}};var Qp="stability.ankle_pitch=0.3";function Jp(i,e,t,n,s){let r=e.trim()===""?NaN:Number(e);if(r>=t&&r<=n)return r;throw new Error(`“${i}” is '${e}', and must be ${t} … ${n} ${s}`)}function TC(i){return i.split(`
`).map((e,t)=>({line:e.trim(),index:t})).filter(({line:e})=>e!=="").map(({line:e,index:t})=>{let n=/^([\w-]+\.[\w.-]+)\s*=\s*(.+)$/.exec(e);if(!n)throw new Error(`Line ${t+1} of the settings is '${e}', and must be PLUGIN.PARAMETER=VALUE, such as ${Qp}`);return`${n[1]}=${n[2]}`})}function V_(i,e){let t={walk:[],duration:0,motion:"",goal:[],settings:TC(i.settings),reason:""};if(i.kind==="walk"){let n=(s,r)=>Jp(s,r,-e.forward,e.forward,"m/s");if(t.walk=[n("forward",i.forward),n("left",i.left),Jp("turn",i.turn,-e.turn,e.turn,"rad/s")],t.duration=Jp("for",i.seconds,.5,599,"s"),t.walk.every(s=>s===0))throw new Error("The walk has no speed: “forward”, “left” and “turn” are 0, and one of them must not be")}else if(i.kind==="motion"){if(i.motion==="")throw new Error("No motion is chosen: choose one of the list");t.motion=i.motion}else if(i.kind==="goal"){if(!i.goal)throw new Error("No goal is chosen: press Walk to, and click the floor in the picture");t.goal=[i.goal.x,i.goal.y,i.goal.yaw]}else if(t.settings.length===0)throw new Error("There are no settings to send: write at least one line PLUGIN.PARAMETER=VALUE");return t}var em=i=>i.trim().length;function G_(i,e){let t=e.trim(),n=em(e);if(n<10)throw new Error(`The reason has ${n} characters, and must have 10 at least: it is recorded with what is sent`);return{...i,reason:t}}var ul=i=>i.toFixed(2);function EC({walk:i,duration:e,motion:t,goal:n,settings:s}){let r=[],[o=0,a=0,l=0]=i,c=a===0&&l===0?"":` ahead, ${ul(a)} to the left, ${ul(l)} rad/s`;i.length>0&&r.push(`walk ${ul(o)} m/s${c}, ${Number(e.toPrecision(6))} s`),t!==""&&r.push(`motion ${t}`);let[h=0,u=0,d=0]=n;return n.length>0&&r.push(`way to ${ul(h)} m, ${ul(u)} m, ${(d*180/Math.PI).toFixed(0)} deg`),[s.join(", "),...r].filter(f=>f!=="").join(", then ")}var H_=({sending:i,sendingWhat:e,sendingText:t,picture:n})=>JSON.stringify([i,e,t,n]),Nu=class{sent;asked;asks(e,t,n){this.asked={request:{...e,reason:""},at_ms:n,before:H_(t),answered:!1}}begun(){this.asked&&(this.sent=void 0,this.asked.answered=!0)}refused(){this.asked=void 0}told(e){if(!this.asked||H_(e)===this.asked.before)return;let{request:t,answered:n}=this.asked;!(n&&e.sending==="trying")&&e.sendingWhat!==EC(t)||(this.sent={request:t,what:e.sendingWhat},this.asked=void 0)}isAsking(e){return this.asked!==void 0&&e-this.asked.at_ms<6e3}requestOf(e){return this.sent?.what===e?this.sent.request:void 0}};var AC=[["walk","Walk"],["motion","Motion"],["goal","Goal on the map"],["settings","Settings only"]];function Fu(i,e,t,n,s,r={}){let o=A("input",{id:`twin-${i}`,type:"number",step:s,value:n,...r,inputmode:"text"});return{label:A("label",{for:`twin-${i}`},e,o,t),input:o}}var Uu=class{constructor(e,t,n){this.context=e;this.known=t;this.send=n;let{motions:s}=e.description;this.motion=A("select",{id:"twin-motion"},A("option",{value:""},"choose…"),...s.map(a=>A("option",{value:a},Cr(a))));let r=[this.forward,this.left,this.turn,this.seconds].map(({label:a})=>a);this.parts={walk:A("div",{},A("div",{class:"fields"},...r),this.walkFrom),motion:A("div",{class:"fields"},A("label",{for:"twin-motion"},"motion",this.motion)),goal:A("div",{},this.goalShown),settings:A("div",{})};let o=A("div",{class:"segments",role:"group","aria-label":"What is sent"});for(let[a,l]of AC){let c=ke(l,()=>this.choose(a),{"aria-pressed":"false",id:`twin-kind-${a}`});this.choices.set(a,c),o.append(c)}this.box=A("form",{class:"twin-send",novalidate:!0,"aria-labelledby":"twin-send-title"},A("h2",{id:"twin-send-title"},"Send to the robot"),o,...Object.values(this.parts),A("label",{class:"settings",for:"twin-settings"},"Settings that go first: PLUGIN.PARAMETER=VALUE, one a line",this.settings),this.submit,this.why),this.box.addEventListener("submit",a=>{a.preventDefault(),this.read()}),this.choose("walk")}box;forward=Fu("forward","forward","m/s",.1,.01);left=Fu("left","left","m/s",0,.01);turn=Fu("turn","turn","rad/s",0,.01);seconds=Fu("seconds","for",`s (${.5} to ${599})`,10,.1,{min:.5,max:599});walkFrom=A("p",{class:"note",id:"twin-walk-from"});motion;goalShown=A("p",{id:"twin-goal"});settings=A("textarea",{id:"twin-settings",rows:2,spellcheck:!1,autocomplete:"off",autocapitalize:"off",placeholder:Qp});submit=A("button",{type:"submit",class:"primary send",id:"twin-send"},"Try, then send");why=A("p",{class:"note",id:"twin-send-why",role:"status"});parts;choices=new Map;kind="walk";filled;look(e){this.fillWalk();let t=this.known.goal();he(this.goalShown,t?`To ${Qh(t)} of the map.`:"No goal is chosen: press Walk to, and click the floor in the picture."),this.submit.disabled=e!=="",he(this.why,e||"Nothing reaches the robot there unless all simulated robots that try it stay up.")}choose(e){this.kind=e;for(let[t,n]of this.choices)n.setAttribute("aria-pressed",String(t===e));for(let[t,n]of Object.entries(this.parts))n.hidden=t!==e}fillWalk(){let e=this.known.walk();!e||e===this.filled||(this.filled=e,this.forward.input.value=String(e.forward),this.left.input.value=String(e.left),this.turn.input.value=String(e.turn),this.seconds.input.value=String(Math.min(e.duration_s,599)),he(this.walkFrom,"As it was driven here last."))}read(){let{news:e,description:t}=this.context;try{this.send(V_({kind:this.kind,forward:this.forward.input.value,left:this.left.input.value,turn:this.turn.input.value,seconds:this.seconds.input.value,motion:this.motion.value,goal:this.known.goal(),settings:this.settings.value},t.bounds))}catch(n){e.say(n.message,"bad","send")}}};var $_={up:"stayed up and did it",fell:"fell",refused:"did not do it",failed:"fell or did not do it"},RC=1e3;function X_({passed:i,tried:e,sendingText:t}){let n=Math.min(e,RC),s=Math.min(i,n),r=/; robot \d+ fell after /.test(t)?"fell":/; robot \d+: /.test(t)?"refused":"failed";return Array.from({length:n},(o,a)=>a<s?"up":r==="fell"&&a>s?"failed":r)}function nm(i){return Object.keys($_).map(t=>({mark:t,count:i.filter(n=>n===t).length})).filter(({count:t})=>t>0).map(({mark:t,count:n})=>`${n} ${$_[t]}`).join(", ")}function q_({sending:i,passed:e,tried:t}){let n=e===t?"good":"bad";switch(i){case"trying":return["now","",""];case"sending":return["good",n,"now"];case"done":return["good",n,"good"];case"not passed":return["good","bad",""];case"failed":return t>0?["good",n,"bad"]:["bad","",""];default:return["","",""]}}var Ou="The worst of the simulated robots",Bu=class{figure;canvas=A("canvas",{id:"twin-worst",role:"img","aria-label":Ou});large;constructor(){let e=ke("",()=>this.open(),{class:"enlarge",id:"twin-worst-open",title:"Show it large","aria-haspopup":"dialog"});e.append(this.canvas),this.figure=A("figure",{class:"worst",hidden:!0},e,A("figcaption",{},`${Ou}. Click it to see it large.`))}async show(e){let t=await createImageBitmap(new Blob([e],{type:"image/png"}));this.canvas.width=t.width,this.canvas.height=t.height,this.canvas.getContext("2d")?.drawImage(t,0,0),t.close(),this.figure.hidden=!1,this.large&&this.copyTo(this.large.canvas)}hide(){this.figure.hidden=!0,this.large?.dialog.close()}open(){if(this.large)return;let e=A("canvas",{id:"twin-worst-large",role:"img","aria-label":Ou}),t=A("dialog",{class:"large-picture",id:"twin-worst-dialog","aria-label":Ou});t.append(e,ke("Close",()=>t.close(),{class:"plain",id:"twin-worst-close"})),e.addEventListener("click",()=>t.close()),this.copyTo(e),this.large={dialog:t,canvas:e},nu(t,()=>this.large=void 0)}copyTo(e){e.width=this.canvas.width,e.height=this.canvas.height,e.getContext("2d")?.drawImage(this.canvas,0,0)}};var CC=20,PC={idle:"",trying:"Being tried on simulated robots",sending:"The robot there does it",done:"Done","not passed":"Not sent",failed:"Failed",stopped:"Stopped"},Hu=class{constructor(e){this.nevertheless=e;this.reasonForm=A("form",{class:"reason",novalidate:!0,hidden:!0},A("label",{for:"twin-reason"},"Why is it to be sent nevertheless?",this.reason),A("p",{class:"note",id:"twin-reason-note"},this.count," The reason is recorded with what is sent. It is tried again on simulated robots first, and then sent even if some of them fall."),this.submit),this.reason.addEventListener("input",()=>this.countReason()),this.countReason(),this.reasonForm.addEventListener("submit",t=>{t.preventDefault(),this.submit.disabled||this.nevertheless(this.reason.value)}),this.box=A("section",{class:"sending","aria-labelledby":"twin-sending",hidden:!0},this.heading,this.what,A("ol",{class:"stages"},...this.stages),this.dotRow,this.counts,this.text,this.worst.figure,this.reasonForm,this.elsewhere)}box;worst=new Bu;heading=A("h2",{id:"twin-sending",role:"status"});what=A("p",{class:"sending-what",id:"twin-sending-what"});stages=["Try","Verdict","Robot there"].map(e=>A("li",{},e));dots=Array.from({length:CC},()=>A("i"));dotRow=A("div",{class:"robots",role:"img"},...this.dots);counts=A("p",{class:"note",id:"twin-robots"});text=A("p",{id:"twin-sending-text"});reason=A("textarea",{id:"twin-reason",rows:2,minlength:10,"aria-describedby":"twin-reason-note"});count=A("span",{id:"twin-reason-count",class:"number"});submit=A("button",{type:"submit",id:"twin-nevertheless",class:"danger",disabled:!0},"Send it nevertheless");reasonForm;elsewhere=A("p",{class:"note"},"It was sent from elsewhere: only there it can be sent nevertheless.");show(e,t){let{sending:n,sendingWhat:s,sendingText:r,tried:o}=e;this.box.hidden=n==="idle",this.box.dataset.sending=n,he(this.heading,PC[n]),he(this.what,s),he(this.text,r);let a=q_(e);for(let[h,u]of this.stages.entries())u.className=a[h]??"";let l=X_(e);for(let[h,u]of this.dots.entries())u.className=l[h]??"";he(this.counts,nm(l)),this.counts.hidden=o===0,this.dotRow.hidden=o===0&&n!=="trying",this.dotRow.setAttribute("aria-label",nm(l)||"None has been tried yet");let c=n==="not passed";!c&&!this.reasonForm.hidden&&(this.reason.value="",this.countReason()),this.reasonForm.hidden=!c||!t,this.elsewhere.hidden=!c||t,n==="trying"&&this.worst.hide()}countReason(){let e=em(this.reason.value);this.submit.disabled=e<10,he(this.count,e<10?`${e} of ${10} characters.`:`${e} characters.`)}};var mi=class{list=A("dl",{class:"facts"});values=new Map;set(e,t,n=!1){let s=this.values.get(e);s||(s=A("dd"),this.values.set(e,s),this.list.append(A("div",{},A("dt",{},e),s))),he(s,t),s.classList.toggle("bad",n)}};var IC={connected:"live",connecting:"old",lost:"lost",refused:"lost"},Vu=class{constructor(e,t){this.context=e;this.orders=t;this.again=ke("Connect again",()=>void e.attempt("Connect again",()=>t.reconnect(),"begun"),{id:"twin-again",hidden:!0}),this.followButton=ke("",()=>this.setFollows(),{role:"switch",id:"twin-follow",class:"switch","aria-checked":"false","aria-describedby":"twin-follows-why"}),this.followButton.append(A("span",{class:"knob-box"}),"The simulated robot does what it does"),this.box=A("section",{class:"twin-status","aria-label":"The robot there"},A("div",{class:"twin-head"},this.lamp,this.address,this.again),this.why,this.verdict,this.facts.list,A("div",{class:"twin-follows"},this.followButton,this.followsWhy))}box;lamp=A("p",{class:"lamp lost",id:"twin-link",role:"status"});address=A("span",{class:"path"});why=A("p",{class:"twin-why",id:"twin-why",role:"status"});again;verdict=A("p",{class:"twin-verdict",id:"twin-verdict"});facts=new mi;followButton;followsWhy=A("small",{id:"twin-follows-why",role:"status"});follows=!1;show(e,t,n,s){let r=e.link==="connected"&&!(n<=Hs);this.lamp.className=`lamp ${s?"lost":r?"old":IC[e.link]}`,he(this.lamp,s?"not heard of":r?"connected, old":e.link),he(this.address,e.robot),this.again.hidden=e.link!=="refused"||s,he(this.why,s?"The simulator tells nothing of it any more.":e.text),this.why.hidden=this.why.textContent==="",this.verdict.className=`twin-verdict ${t.verdict}`,he(this.verdict,t.text);let o=e.link==="connected"&&!s;this.facts.set("does",o&&e.activity?e.activity:"not known",o&&["falls","fallen","gone"].includes(e.activity)),this.facts.set("commander",o?e.commander||"nobody":"not known"),this.facts.set("age",Number.isFinite(n)?Nn(1e3*n):"nothing yet",!(n<=Hs)),this.facts.set("lag",o&&Number.isFinite(e.lag_s)?Nn(1e3*e.lag_s):"not known"),this.follows=e.follows,this.followButton.setAttribute("aria-checked",String(e.follows)),this.followButton.disabled=s,he(this.followsWhy,e.follows||e.followsText===""?"":`It does not: ${e.followsText}.`)}setFollows(){let e=!this.follows;this.context.attempt(e?"Do what the robot there does":"Do not follow the robot there",()=>this.orders.follow(e))}};var Y_=i=>!/^connected\b|\bdone$|: done: /.test(i),dl=i=>i?`: ${i}`:"";function LC(i,{link:e,text:t,robot:n}){if(i.link===e)return[];let s="robot there";return e==="connected"?[{about:s,text:`The robot there is connected${n?`: ${n}`:""}`,weight:"good"}]:e==="lost"?[{about:s,text:`The robot there is lost${dl(t)}. It is tried again by itself.`,weight:"bad"}]:e==="refused"?[{about:s,text:`The robot there has been refused${dl(t)}. It is not tried again before you press Connect again.`,weight:"bad"}]:[]}function kC(i,{sending:e,sendingWhat:t,sendingText:n}){if(i.sending===e)return[];let s="sending";switch(e){case"sending":return[{about:s,text:`The robot there begins: ${t}`,weight:"plain"}];case"done":return[{about:s,text:`The robot there has done it: ${t}`,weight:"good"}];case"not passed":return[{about:s,text:`Not sent: ${t}${dl(n)}`,weight:"bad"}];case"failed":return[{about:s,text:`Sending has failed: ${t}${dl(n)}`,weight:"bad"}];case"stopped":return[{about:s,text:`Stopped: ${t}${dl(n)}`,weight:"plain"}];default:return[]}}function Z_(i,e){let n=i.follows&&!e.follows&&e.followsText!==""?[{about:"follows",text:`The simulated robot does not follow any more: ${e.followsText}`,weight:"plain"}]:[];return[...LC(i,e),...n,...kC(i,e)]}var DC=2e3,Gu=class{constructor(e,t,n,s,r){this.context=e;this.orders=t;this.history=n;this.now=s;this.status=new Vu(e,t),this.table=new Du(o=>this.choose(o)),this.form=new Uu(e,r,o=>void this.send(o)),this.sending=new Hu(o=>this.sendNevertheless(o)),this.content=A("div",{class:"twin-tab"},this.status.box,A("h2",{},"Differences"),this.table.box,this.plot.box,this.form.box,this.sending.box,A("h2",{},"What was told"),this.noneTold,this.told)}title="Twin";content;shown=!1;status;plot=new ku;table;told=A("ol",{class:"events told",id:"twin-told"});noneTold=A("p",{class:"note"},"Nothing has been told yet.");form;sending;sent=new Nu;chosen;picture=0;pictureFailed_ms=-1/0;toldKey="";wantsToBeSeen=!1;show(){this.shown=!0,document.body.classList.add("views-twin")}hide(){this.shown=!1,document.body.classList.remove("views-twin")}take(e){this.sent.told(e)}isAsking(e){return this.sent.isAsking(e)}look(e){let{state:t,agreement:n,age_s:s,silent:r}=this.now();this.status.show(t,n,s,r);for(let c of[this.table.box,this.plot.box])c.classList.toggle("was",n.verdict==="lost"||n.verdict==="unknown");this.table.show(t.channels,e),this.chosen??=il(t.channels)[0]?.name;let o=t.channels.findIndex(({name:c})=>c===this.chosen),a=t.channels[o];this.plot.box.hidden=!a,a&&(this.table.setChosen(a.name),this.plot.draw(a,o,this.history,e)),this.form.look(this.hindrance(t,r));let l=this.sent.requestOf(t.sendingWhat)!==void 0;this.sending.show(t,l),this.wantsToBeSeen&&l&&!this.sending.box.hidden&&(this.wantsToBeSeen=!1,this.sending.box.scrollIntoView({block:"start"})),this.showTold(t),this.keepPicture(t,e)}choose(e){this.chosen=e,this.table.setChosen(e),this.plot.makeAnew(),this.look(performance.now()),this.plot.box.scrollIntoView({block:"nearest"})}hindrance({link:e,sending:t,text:n},s){return s?"The simulator tells nothing: nothing can be sent.":e!=="connected"?`The robot there is not connected: nothing can be sent.${n?` ${n}`:""}`:Lo({sending:t})?"Something is being sent already: wait for it, or stop the robot there.":""}async send(e){this.sent.asks(e,this.now().state,performance.now()),await this.context.attempt("Send to the robot there",()=>this.ask(e),"it is tried on simulated robots first")&&(this.wantsToBeSeen=!0)}async ask(e){try{await this.orders.send(e),this.sent.begun()}catch(t){throw t instanceof Fn&&this.sent.refused(),t}}sendNevertheless(e){let t=this.sent.requestOf(this.now().state.sendingWhat);if(t)try{this.send(G_(t,e))}catch(n){this.context.news.say(n.message,"bad","send")}}showTold({told:e}){let t=e.map(({at_s:n,text:s})=>`${n} ${s}`).join(`
`);t!==this.toldKey&&(this.toldKey=t,this.noneTold.hidden=e.length>0,this.told.replaceChildren(...e.map(({at_s:n,text:s})=>A("li",{class:Y_(s)?"warning":""},A("span",{class:"number"},Number.isFinite(n)?`${n.toFixed(1)} s `:"– "),s))))}keepPicture({picture:e,sending:t},n){if(!(e===this.picture||n-this.pictureFailed_ms<DC||t==="trying")){if(this.picture=e,e===0){this.sending.worst.hide();return}this.orders.picture().then(s=>this.sending.worst.show(s)).catch(s=>{this.picture=0,this.pictureFailed_ms=performance.now(),this.context.news.say(`The picture of the worst simulated robot does not come: ${s.message}`,"bad","twin picture")})}}};var Wu=class{constructor(e,t){this.context=e;this.orders=t;this.button=ke("Stop the robot there",()=>{},{id:"twin-stop",class:"stop stop-there",hidden:!0}),this.button.append(this.what),this.button.addEventListener("pointerdown",n=>n.button===0&&this.stop("Stop the robot there")),this.button.addEventListener("click",n=>n.detail===0&&this.stop("Stop the robot there")),tt("stops").prepend(this.button)}button;what=A("small");isHeard=!1;too(){this.stop("Stop the robot there, too")}show(e,t){let n=Lo(e);this.isHeard=e.link==="connected",this.button.hidden=!n&&!t;let s=e.link==="lost"?"it is not heard of":"",r=n?`${e.sending==="trying"?"being tried":"it does"}: ${e.sendingWhat}`:this.isHeard&&e.commander?`${e.commander} commands it`:"";he(this.what,[s,r].filter(o=>o!=="").join("; ")),this.what.hidden=this.what.textContent===""}stop(e){this.context.attempt(e,()=>this.orders.stop(),this.isHeard?"it is told":"it is tried, but the robot there is not heard of: see What was told")}};var $u=class{constructor(e){this.robot=e}async follow(e){await this.robot.order("/simulation/twin/follow",{data:e},5e3)}async send(e){await this.robot.order("/simulation/twin/send",e,5e3)}async stop(){await this.robot.order("/simulation/twin/stop",{},5e3)}async reconnect(){await this.robot.order("/simulation/twin/reconnect",{},5e3)}picture(){return NC(e=>this.picturePart(e))}async picturePart(e){let t=await this.robot.order("/simulation/twin/picture",{first:e},5e3);return{total:Number(t.total),bytes:Uint8Array.from(atob(String(t.data)),n=>n.charCodeAt(0))}}};async function NC(i){for(let e=0;e<3;++e){let t=await FC(i);if(t)return t}throw new Error("the picture became another one 3 times while it was read")}async function FC(i){let{total:e,bytes:t}=await i(0);if(!(e>0&&e<=16e6))throw new Error(`the picture has ${e} bytes, and must have 1 … 16000000`);let n=new Uint8Array(e);for(let s=0;;){if(e!==n.length)return;if(t.length===0||s+t.length>e)throw new Error(`the picture has ${e} bytes, but its part from ${s} on has ${t.length}`);if(n.set(t,s),s+=t.length,s===e)return n;({total:e,bytes:t}=await i(s))}}var im=class{constructor(e,t,n){this.context=e;this.place=t;this.state=n;let{picture:s,tabs:r}=t,o=new $u(e.robot);this.robot=new fu(e.description),s.addTwin(this.robot),this.robot.loadMeshes(e.token(),()=>s.ask()).catch(()=>{}),this.tab=new Gu(e,o,this.history,()=>this.now(performance.now()),t),r.add(this.tab),this.stop=new Wu(e,o),t.stops.other={isToStop:()=>Lo(this.state)||this.tab.isAsking(performance.now()),stop:()=>this.stop.too()},this.toggle=ke("Twin",()=>this.setShown(this.toggle.getAttribute("aria-pressed")!=="true"),{id:"twin-show",class:"twin-show","aria-pressed":"true",title:"Show the robot there, as measured"}),this.chip=ke("",()=>r.open(this.tab),{id:"twin-chip",class:"twin-chip",title:"Open the view of the twin"}),tt("picture").append(A("div",{class:"twin-glance",role:"group","aria-label":"The robot there"},this.toggle,this.chip)),document.body.classList.add("has-twin"),document.querySelector(".legend")?.append(A("li",{class:"there"},"robot there, measured")),this.tell({...n,link:"connecting"},n)}robot;history=new Lu;tab;stop;toggle;chip;came_ms=0;take(e,t){e!==this.state&&this.tell(this.state,e),this.state=e,this.came_ms=t;let{base:n,joints:s}=e;this.robot.show(n&&s?{base:n,joints:s}:void 0,t);let r=e.link==="connected"&&e.age_s<=Hs;this.history.add(r?e.channels:[],t/1e3),this.tab.take(e),this.look(t),this.place.picture.ask()}look(e){let{agreement:t,age_s:n,silent:s}=this.now(e);this.robot.setFaded(s||this.state.link!=="connected"||!(n<=Hs)),this.stop.show(this.state,this.tab.shown),he(this.chip,t.short),this.chip.dataset.verdict=t.verdict;let r=tt(this.tab.content.getAttribute("aria-labelledby")??"");r.dataset.verdict=t.verdict}now(e){let t=(e-this.came_ms)/1e3,n=t*1e3>lv,s=this.state.age_s+Math.max(t,0),r=n?{verdict:"lost",text:"Nothing is compared: the simulator tells nothing.",short:"Robot there: not heard of"}:hv(this.state,s);return{state:this.state,agreement:r,age_s:s,silent:n}}setShown(e){this.toggle.setAttribute("aria-pressed",String(e)),this.robot.setWanted(e),this.place.picture.ask()}tell(e,t){for(let{text:n,weight:s,about:r}of Z_(e,t))this.context.news.say(n,s,r)}};function K_(i,e){let t;return i.robot.subscribe(vp.name,vp.type,0,n=>{let s=cv(n);t??=new im(i,e,s),t.take(s,performance.now())}),n=>t?.look(n)}var UC=1.3,sm=class{constructor(e,t){this.context=e;this.place=t;let{scene:n,canvas:s,tools:r,tabs:o}=t,a=new eu(e.robot);this.picture=new Zh(n,e.description,e.token());let l=()=>this.state?.state==="playing";this.way=new hu(e,a,this.picture,n,s,r,l,()=>l()||t.stops.stopsOther||document.querySelector("dialog[open]")!==null);let c=Py(e,a),h=Hy(e,a,this.picture,s,r);o.add(h,c),r.add(this.way.tool,h.tool),this.bar=new ou(e,a,[ke("Things",()=>o.open(h),{id:"open-things",title:"Put things into the world, move them"}),ke("Faults",()=>o.open(c),{id:"open-faults",title:"Let something go wrong"})]),this.worldChanged=()=>{this.way.worldChanged(),h.worldChanged()},this.world=new uu(u=>a.geometry(u),(u,d)=>{this.picture.setSolids(u,d),this.state&&this.picture.show(this.state,this.trail.originFor(this.state)),this.worldChanged()},u=>e.news.say(`The world is not known: ${u.message}`,"bad","world")),e.frameTakers.push(u=>this.trail.take(u)),document.body.classList.add("simulated"),tt("panel").before(this.bar.box),tt("camera").prepend(this.way.tool.toggle),tt("picture").append(this.way.card.box),document.querySelector(".legend")?.append(A("li",{class:"left-step"},"left step"),A("li",{class:"right-step"},"right step")),n.zoom(UC),this.lookAtTwin=K_(e,{picture:this.picture,tabs:o,stops:t.stops,goal:()=>this.way.goal,walk:()=>t.driver.lastWalk.walk}),this.way.tool.setOn(!0)}bar;picture;way;world;worldChanged;lookAtTwin;trail=new tu;state;came_ms=0;take(e,t){let n=this.state!==void 0&&this.state.run!==e.run;(n||t-this.came_ms>np||this.state?.world!==e.world)&&this.world.forget(),this.state=e,this.came_ms=t,this.context.freshness.pace=dy(e),n&&this.jumped(),this.picture.show(e,this.trail.originFor(e)),this.bar.show(e),this.world.take(e.geometry,t)}jumped(){this.context.command.lost(),this.trail.forget(),this.place.scene.forgetSteps(),this.way.jumped()}look(e){let t=e-this.came_ms>np,{stops:n,banner:s}=this.place;t&&(this.context.freshness.pace=1),n.setSpaceStops(t),s.rests=!t&&this.state?.state!=="playing",this.bar.setSilent(t),this.way.look(e),this.lookAtTwin(e)}};function j_(i,e){let t;return i.robot.subscribe(tp.name,tp.type,0,n=>{t??=new sm(i,e),t.take(uy(n),performance.now())}),n=>t?.look(n)}function J_(i,e){i.addEventListener("pointerdown",t=>t.button===0&&e()),i.addEventListener("click",e)}var Xu=class{constructor(e,t){this.context=e;this.ended=t;J_(this.stopButton,()=>this.stop()),J_(this.emergencyButton,()=>this.emergencyStop()),this.releaseButton.addEventListener("click",()=>this.release()),document.addEventListener("keydown",n=>this.key(n),{capture:!0}),document.addEventListener("keyup",n=>n.code==="Space"&&!Js(n.target)&&n.preventDefault(),{capture:!0})}other;stopButton=tt("stop");emergencyButton=tt("emergency");releaseButton=tt("release");keys=this.stopButton.querySelector("small");spaceStops=!0;stop(){this.stopOther(),this.ended(),this.tellIfPaused(),this.context.attempt("Stop",()=>this.context.robot.stop("/stop"))}setSpaceStops(e){e!==this.spaceStops&&(this.spaceStops=e,this.stopButton.setAttribute("aria-keyshortcuts",e?"Escape Space":"Escape"),this.keys&&he(this.keys,e?"Esc, Space":"Esc"))}show(e){let t=e.mode[0]===Ss.emergencyStop;this.releaseButton.hidden=!t,this.emergencyButton.setAttribute("aria-pressed",String(t))}get stopsOther(){return this.other?.isToStop()??!1}stopOther(){this.stopsOther&&this.other?.stop()}tellIfPaused(){this.context.freshness.pace===0&&this.context.news.say("The simulation is paused: the robot stops as soon as it plays on.","plain","stop while paused")}emergencyStop(){this.stopOther(),this.ended(),this.tellIfPaused(),this.context.attempt("Emergency stop",()=>this.context.robot.stop("/emergency_stop",{data:!1}))}release(){let{attempt:e,command:t,robot:n}=this.context;e("Release",async()=>{t.mine||await t.take(),await n.order("/release")})}key(e){let t=e.code==="Escape"||this.spaceStops&&e.code==="Space"&&!Js(e.target);if(!t||e.repeat){t&&e.preventDefault();return}e.preventDefault(),e.stopPropagation(),this.stop()}};var qu=class{constructor(e,t,n){this.bar=e;this.panels=t;this.add(...n),e.addEventListener("keydown",s=>this.step(s,[...this.buttons.keys()])),n[0]&&this.open(n[0])}current;buttons=new Map;add(...e){for(let t of e){let n=`tab-${this.buttons.size}`,s=A("button",{type:"button",role:"tab",id:n,"aria-controls":`${n}-panel`,"aria-selected":"false",tabindex:-1},t.title);t.content.id=`${n}-panel`,t.content.setAttribute("role","tabpanel"),t.content.setAttribute("aria-labelledby",n),t.content.hidden=!0,s.addEventListener("click",()=>this.open(t)),this.buttons.set(t,s),this.bar.append(s),this.panels.append(t.content)}}look(e){this.current?.look?.(e)}open(e){if(e!==this.current){this.current?.hide?.(),this.current=e;for(let[t,n]of this.buttons){let s=t===e;n.setAttribute("aria-selected",String(s)),n.tabIndex=s?0:-1,t.content.hidden=!s}this.buttons.get(e)?.scrollIntoView({inline:"nearest",block:"nearest"}),this.panels.scrollTop=0,e.show?.(),e.look?.(performance.now())}}step(e,t){let s={ArrowRight:1,ArrowLeft:-1}[e.key];if(s===void 0||!this.current)return;e.preventDefault(),e.stopPropagation();let r=t[(t.indexOf(this.current)+s+t.length)%t.length];r&&(this.open(r),this.buttons.get(r)?.focus())}};function rm({type:i,name:e}){return e===""?i:e.startsWith(`${i}#`)?`${i} ${e.slice(i.length)}`:`${i} “${e}”`}var Yu=class{revision=-1;nodes;counted=-1;waiting=[];state;log=[];told=0;missed=0;takeNodes({revision:e,parent:t,type:n,name:s}){e!==this.revision&&this.begin(e);let r=[];t.forEach((o,a)=>r.push(a===0?0:(r[o]??0)+1)),this.nodes=r.map((o,a)=>({depth:o,type:n[a]??"",name:s[a]??""})),this.tellWaiting()}takeState(e){e.revision!==this.revision&&this.begin(e.revision),e.transitions<this.counted&&(this.counted=-1);let t=this.counted<0?e.newest.length:e.transitions-this.counted;this.missed+=this.counted<0?0:Math.max(0,t-e.newest.length),this.counted=e.transitions,this.state=e,t>0&&this.waiting.push(...e.newest.slice(-t)),this.tellWaiting()}rows(){return this.nodes?.map((e,t)=>({node:e,status:this.state?.revision===this.revision?this.state.status[t]:void 0}))}begin(e){this.revision=e,this.nodes=void 0,this.waiting=[]}tellWaiting(){if(this.nodes){for(let{time_s:e,node:t,to:n}of this.waiting){let s=this.nodes[t];s&&(this.log.unshift({time_s:e,what:rm(s),to:n}),++this.told)}this.waiting=[],this.log.length=Math.min(this.log.length,200)}}};var OC=3e3,BC=5e3,Q_={idle:"·",running:"▶",success:"✓",failure:"✕",skipped:"↷"},zC={none:"no mission",runs:"runs",halts:"comes to its end",succeeded:"has succeeded",failed:"has failed",waits:"waits"};function HC(){let i=A("span",{class:"mark","aria-hidden":"true"}),e=A("span"),t=A("small"),n=A("li",{},i," ",e," ",t);return{row:n,show:(s,r,o)=>{n.className=o??"unknown",n.style.setProperty("--depth",String(s)),n.setAttribute("aria-level",String(s+1)),he(i,o?Q_[o]:"?"),he(e,r),he(t,o==="idle"||o===void 0?"":o)}}}function VC({time_s:i,what:e,to:t}){return A("li",{class:t},A("span",{class:"number"},i.toFixed(2))," ",A("span",{class:"mark","aria-hidden":"true"},Q_[t]),` ${e}: ${t}`)}function ex({robot:i,attempt:e,command:t}){let n=(N,T={})=>t.during(()=>i.order(N,T,BC)),s=new Yu,r,o,a=-1/0,l=new mi,c=A("p",{class:"hint",role:"status"}),h=A("p",{class:"hint"}),u=A("input",{id:"mission",placeholder:"name or file of a mission","aria-label":"Mission",spellcheck:!1,autocomplete:"off",enterkeyhint:"go"}),d=A("form",{class:"tools"},u,A("button",{type:"submit"},"Start")),f=ke("End it",()=>void e("End the mission",()=>n("/behaviour/end"))),g=ke("Take its file anew",()=>void e("Change the mission",()=>n("/behaviour/change")));d.addEventListener("submit",N=>{N.preventDefault();let T=u.value.trim();e(T===""?"Start the mission":`Start ${T}`,()=>n("/behaviour/start",{mission:T}))});let v=[],m=A("ol",{class:"tree",tabindex:0,"aria-label":"The behaviour tree"}),p=A("ol",{class:"transitions",tabindex:0,"aria-label":"Transitions, the newest first"}),M=A("p",{class:"hint"}),b=0,_=()=>{let N=s.rows()??[];for(;v.length>N.length;)v.pop()?.row.remove();N.forEach(({node:T,status:S},C)=>{let B=v[C];B||(v.push(B=HC()),m.append(B.row)),B.show(T.depth,rm(T),S)})},I=()=>{s.told!==b&&(b=s.told,p.replaceChildren(...s.log.slice(0,60).map(VC)),he(M,s.missed>0?`${s.missed} came faster than they were told.`:""))},R=N=>{let T=N-a>OC;m.classList.toggle("old",T),l.set("mission",r&&r.mission!==""?r.mission:"–"),l.set("state",r?T?"not heard of":zC[r.state]??r.state:"not known",T||r?.state==="failed"),l.set("ticks",r?String(r.ticks):"–"),he(c,r?r.text:"This robot tells of no behaviour."),he(h,!o||!i.isOpen?"":`Command: ${o.commander.replace("_"," ")}; ${o.text}.`),f.disabled=g.disabled=!i.isOpen||!r||r.state==="none",_(),I()};return i.subscribe("/command/state","gaitway_msgs/msg/CommandState",0,N=>o=wl(N)),i.subscribe("/behaviour/state","gaitway_msgs/msg/BehaviourState",0,N=>{r=bl(N),a=performance.now(),s.takeState(r)}),i.subscribe("/behaviour/nodes","gaitway_msgs/msg/BehaviourNodes",0,N=>s.takeNodes(km(N))),{title:"Behaviour",content:A("div",{class:"behaviour-tab"},l.list,c,h,d,A("div",{class:"buttons"},f,g),m,A("h2",{},"Transitions"),M,p),look:R}}async function tx(i,e){let t=await fetch(i,Qi(e));if(!t.ok)throw new Error(await t.text());return t.json()}var nx=i=>tx("motions.json",i),ix=(i,e)=>tx(i,e),GC=.8;function sx(i,{period:e,postures:t}){let n=(t.length-1)*e;return Math.min(i%(n+GC),n)}function rx({period:i,postures:e},t){let n=Math.min(Math.max(t/i,0),e.length-1),s=e[Math.floor(n)],r=e[Math.ceil(n)];if(!s||!r)throw new RangeError("a motion has no postures");let o=(a,l)=>a.map((c,h)=>c+((l[h]??c)-c)*(n-Math.floor(n)));return{joints:o(s.joints,r.joints),feet:[o(s.feet[0],r.feet[0]),o(s.feet[1],r.feet[1])],support:s.support}}function Zu({description:i,duration:e,start:t,refused:n}){if(n!==void 0)return`No preview: ${n}.`;let s=t!=="stands"?" On the ground it is drawn roughly.":"";return`${i??""} ${(e??0).toFixed(1)} s; begins when the robot ${t}.${s}`.trim()}function ox({period:i,postures:e},t){let n=e.findIndex(({support:s})=>s!==3);return n<0?0:Math.min(Math.max(t/Math.max(n*i,i),0),1)}var WC=50,$C={"lies on its front":[0,Math.PI/2],"lies on its back":[0,-Math.PI/2],"lies on its left":[-Math.PI/2,0],"lies on its right":[Math.PI/2,0]},om=class{constructor(e,t){this.canvas=e;let{description:n}=t;this.renderer=new Po({canvas:e,antialias:!0,alpha:!0,powerPreference:"low-power"}),this.body=new Yi(n),rp(this.body);let s=n.hip_height*2,r=new vr(s*1.2,8,9082790,9082790);r.rotation.x=Math.PI/2;let o=new yr(16777215,2.2);o.position.set(1.5,2,4),this.scene.add(this.body.base,r,new gr(16777215,8952234,2.4),o),this.camera.up.set(0,0,1),this.camera.position.set(2*s,1.35*s,.9*s),this.camera.lookAt(0,0,s*.52),this.body.loadMeshes(t.token(),()=>{}).catch(()=>{})}renderer;scene=new hr;camera=new xn(32,1,.05,50);body;box=new Hi;draw(e,t,n){this.body.pose(e.joints),e.support===3?this.layDown(t,n):this.stand(e);let{clientWidth:s,clientHeight:r}=this.canvas;this.renderer.setSize(s,r,!1),this.camera.aspect=s/Math.max(r,1),this.camera.updateProjectionMatrix(),this.renderer.render(this.scene,this.camera)}stand({feet:e,support:t}){let n=t===1?1:0,[s,r,o,a]=e[n],l=new Tt().makeRotationZ(a).setPosition(s,r,o),{base:c}=this.body;c.position.set(0,0,0),c.quaternion.identity(),c.updateMatrixWorld(!0),l.multiply(this.body.solePose(n).invert()).decompose(c.position,c.quaternion,c.scale)}layDown(e,t){let{base:n}=this.body,[s,r]=$C[e]??[0,Math.PI/2];n.quaternion.setFromEuler(new Kn(s,r,0)).slerp(new en,t*t),n.position.set(0,0,0),this.box.setFromObject(n),n.position.set(-(this.box.min.x+this.box.max.x)/2,0,-this.box.min.z)}},Ku=class{constructor(e){this.context=e}canvas=A("canvas",{role:"img","aria-label":"Ghost of the robot that plays a motion"});title=A("strong");text=A("span");figure=A("figure",{class:"preview",hidden:!0},this.canvas,A("figcaption",{role:"status"},this.title," ",this.text,A("small",{},"A preview: the robot does not move.")));known=new Map;picture;shown;get name(){return this.shown?.name}async show(e){if(this.shown!==e&&(this.shown=e,this.figure.hidden=!1,this.canvas.hidden=e.postures===void 0,he(this.title,e.name.replaceAll("_"," ")),he(this.text,Zu(e)),e.postures!==void 0))try{let t=await this.posturesOf(e.postures);this.shown===e&&this.play(e,t)}catch(t){this.known.delete(e.postures),this.shown===e&&he(this.text,`No preview: ${t.message}`)}}hide(){this.shown=void 0,this.figure.hidden=!0}posturesOf(e){let t=this.known.get(e)??ix(e,this.context.token());return this.known.set(e,t),t}play(e,t){this.picture??=new om(this.canvas,this.context);let n=performance.now(),s=-1/0,r=o=>{if(this.shown!==e||(requestAnimationFrame(r),o-s<WC||this.canvas.clientWidth===0))return;s=o;let a=sx(Math.max(o-n,0)/1e3,t);this.picture?.draw(rx(t,a),e.start??"",ox(t,a)),this.figure.dataset.time=a.toFixed(2)};requestAnimationFrame(r)}};var ax=i=>i.replaceAll("_"," ");function lx(i,e,...t){let n=new Ku(i);tt("picture").append(n.figure);let s,r,o=async f=>{r??=nx(i.token()).then(g=>new Map(g.map(v=>[v.name,v])));try{return(await r).get(f)??{name:f,refused:"it is not prepared: run `gaitway motion prepare`"}}catch(g){return r=void 0,{name:f,refused:g.message}}},a,l=async f=>{a=f;let g=await o(f);a===f&&await n.show(g)},c=()=>{a=void 0,n.hide()},h=f=>{s?.setAttribute("aria-pressed","false"),s=f,s?.setAttribute("aria-pressed","true")},u=()=>s?void l(s.value):c(),d=f=>{let g=ke(ax(f),()=>e(f)),v=ke("▷",()=>{h(s===v?void 0:v),u()},{class:"show",value:f,"aria-pressed":"false","aria-label":`Preview ${ax(f)}`,title:"Preview: the robot does not move"});for(let m of[g,v])m.addEventListener("pointerenter",({pointerType:p})=>p==="mouse"&&void l(f)),m.addEventListener("pointerleave",({pointerType:p})=>p==="mouse"&&u()),m.addEventListener("focus",()=>m.matches(":focus-visible")&&void l(f)),m.addEventListener("blur",u);return g.addEventListener("pointerenter",()=>void o(f).then(m=>g.title=Zu(m)),{once:!0}),A("span",{class:"motion"},g,v)};return{group:A("div",{class:"buttons",role:"group","aria-label":"Motions"},...i.description.motions.map(d),...t),hide:()=>{h(void 0),c()}}}var Wo=i=>Number.isNaN(i)?"–":`${i<-.005?"−":""}${Math.abs(i).toFixed(2)}`;function XC(){let i=[],e=["forward, m/s","left, m/s","turn, rad/s"].map(s=>{let r=[0,1,2].map(()=>A("td",{class:"number"}));return i.push(r),A("tr",{},A("th",{scope:"row"},s),...r)}),t=A("tr",{},A("td"),...["asked","is","at most"].map(s=>A("th",{scope:"col"},s)));return{table:A("table",{class:"speeds"},A("caption",{class:"hidden"},"Speeds"),A("thead",{},t),A("tbody",{},...e)),cells:i}}var qC={rests:"Hold the stick, or W A S D: the robot walks while you hold it.",waits:"Asking for the command…",drives:"Driving. Let go, and it stands.",blocked:"Ended. Let go of the stick first."};function YC(i,e,t,n){if(n)return"The simulator is paused: the robot moves once it plays.";if(e?.mode[0]===Ss.emergencyStop)return"The emergency stop holds the robot: it walks once that is released.";if(e?.activity[0]!==Vm)return qC[i];let s=t.filter(r=>r.startsWith("get_up")).map(r=>`“${r.replaceAll("_"," ")}”`);return`The robot lies, and walks nowhere. ${s.length>0?`Below are ${s.join(" and ")}: the side that it lies on decides.`:"Lift it up."}`}function cx(i,e){let{attempt:t,command:n,robot:s,freshness:r,drive:o}=i,{table:a,cells:l}=XC(),c=A("p",{class:"hint",role:"status"}),h=(m,p,M)=>()=>void t(m,async()=>{n.mine||await n.take(),await p()},M),u=ke("Stand",h("Stand",()=>s.order("/stand",{},15e3))),d=ke("Leave the motion",h("Leave the motion",()=>s.order("/play_motion",{motion:""}))),f=lx(i,m=>h(`Motion ${m}`,()=>s.order("/play_motion",{motion:m},15e3),"begun")(),d),g=A("p",{class:"hint",role:"status"}),v=A("div",{class:"drive"},A("div",{class:"sticks"},e.walk.field,A("div",{class:"beside"},e.side.field,c,u)),a,A("h2",{},"Motions"),f.group,g);return s.subscribe("/motion_state","gaitway_msgs/msg/MotionState",200,m=>{let p=m.state!=="none";d.disabled=!p;let M=p?`${m.motion}: ${m.state}, ${Number(m.time).toFixed(1)} of ${Number(m.duration).toFixed(1)} s`:"";he(g,M||(m.result==="none"?"":`${m.motion}: ${m.result}`))}),{title:"Drive",content:v,hide:f.hide,look:()=>{he(c,YC(o.state,r.newest,i.description.motions,r.rests));let{forward:m,left:p,turn:M}=e.sent,b=r.newest?.velocity??[],{bounds:_}=e,I=[`${Wo(-_.backward)} … ${Wo(_.forward)}`,`± ${Wo(_.left)}`,`± ${Wo(_.turn)}`];for(let[R,D]of[m,p,M].entries()){let N=[Wo(D),Wo(b[R]??NaN),I[R]??""];for(let[T,S]of(l[R]??[]).entries())he(S,N[T]??"")}}}}var hx=500,ZC=[{least:0,name:"all"},{least:30,name:"warnings and errors"},{least:40,name:"errors"}];function KC(i){let e=i.stamp;return{time_s:e.sec+e.nanosec*1e-9,level:Number(i.level),source:String(i.name),text:String(i.msg)}}function jC(i,e,t){let n=`${i.source} ${i.text}`.toLowerCase();return i.level>=e&&t.toLowerCase().split(/\s+/).every(s=>n.includes(s))}function ux({time_s:i,level:e,source:t,text:n}){let s=e>=40?"error":e>=30?"warning":"info";return A("li",{class:s},A("span",{class:"number"},i.toFixed(2))," ",A("b",{},s==="info"?t:`${s}: ${t}`),` ${n}`)}function dx({robot:i}){let e=[],t=A("ol",{class:"events",tabindex:0,"aria-label":"Events, the newest first"}),n=A("select",{id:"event-level","aria-label":"Which events"},...ZC.map(({least:h,name:u})=>A("option",{value:h},u))),s=A("input",{type:"search",placeholder:"filter by words","aria-label":"Filter by words"}),r=h=>jC(h,Number(n.value),s.value),o=A("p",{class:"hint",role:"status"}),a=()=>he(o,t.childElementCount>0?"":e.length>0?`None of ${e.length} events passes the filter.`:"No event yet."),l=()=>{t.replaceChildren(...e.filter(r).map(ux)),a()};n.addEventListener("change",l),s.addEventListener("input",l),i.subscribe("/events","rcl_interfaces/msg/Log",0,h=>{let u=KC(h);for(e=[u,...e.slice(0,hx-1)],r(u)&&t.prepend(ux(u));t.childElementCount>hx;)t.lastElementChild?.remove();a()}),a();let c=ke("Clear",()=>{e=[],l()});return{title:"Events",content:A("div",{class:"events-tab"},A("div",{class:"tools"},n,s,c),o,t)}}var ju=class{constructor(e){this.curves=e;this.columns=Array.from({length:e.length+1},()=>[])}columns;add(e){let t=e.robot_time[0]??0,n=this.columns[0]??[],s=n[n.length-1];typeof s=="number"&&t<s&&this.columns.forEach(r=>r.length=0),typeof s=="number"&&t-s>.3&&this.columns.forEach((r,o)=>r.push(o===0?(s+t)/2:null)),n.push(t);for(let[r,{value:o}]of this.curves.entries()){let a=o(e);this.columns[r+1]?.push(a===void 0||Number.isNaN(a)?null:a)}n.length>3600*1.1&&(this.columns=this.columns.map(r=>r.slice(-3600)))}data(e,t){let n=this.columns[0],s=(n[n.length-1]??0)-t,r=n.findIndex(o=>o>=s);return[0,...e.map(o=>o+1)].map(o=>(this.columns[o]??[]).slice(Math.max(r,0)))}};var JC=200,QC=[10,30,120],eP=["#2f7fd6","#d9822b","#2ba06a","#b04fc4"];function tP({description:i}){let e=(n,s,r)=>({name:r,value:o=>o[n][s]}),t=n=>({name:"°",value:s=>(s.joint[n]??NaN)*180/Math.PI});return[{title:"Speed, m/s and rad/s",curves:[e("velocity",0,"forward"),e("velocity",1,"left"),e("velocity",2,"turn")]},{title:"Load on the feet, N",curves:[e("foot_force",0,"left"),e("foot_force",1,"right")]},{title:"ZMP along x, m from the base",curves:[e("zmp",0,"measured"),e("planned_zmp",0,"planned"),e("com",0,"CoM")]},{title:"ZMP along y, m from the base",curves:[e("zmp",1,"measured"),e("planned_zmp",1,"planned"),e("com",1,"CoM")]},{title:"Height, m",curves:[e("base_height",0,"base"),e("com",2,"CoM")]},{title:"Age at the robot and way there and back, s",curves:[e("age",0,"joints"),e("age",1,"pose"),e("round_trip",0,"way")]},...i.joints.map(({name:n},s)=>({title:`${n.replaceAll("_"," ")}, °`,curves:[t(s)]}))]}var am=class{constructor(e,t,n,s){this.plots=e;this.histories=t;this.held=s;let r=A("select",{"aria-label":"What this plot shows"},...e.map(({title:o},a)=>A("option",{value:a},o)));r.value=String(n),r.addEventListener("change",()=>this.choose(Number(r.value))),this.box.append(r),this.chosen=n}box=A("figure");plot;chosen=0;choose(e){this.chosen=e,this.makeAnew()}makeAnew(){this.plot?.destroy(),this.plot=void 0}draw(e){let{curves:t}=this.plots[this.chosen],n=this.histories[this.chosen]?.data(t.map((r,o)=>o),e);this.plot??=this.make(t);let s=this.box.clientWidth;s>0&&s!==this.plot.width&&this.plot.setSize({width:s,height:this.plot.height}),this.plot.setData(n,!this.held())}zoom(e){let{min:t=0,max:n=0}=this.plot?.scales.x??{},s=((t??0)+(n??0))/2,r=((n??0)-(t??0))/2*e;this.plot?.setScale("x",{min:s-r,max:s+r})}make(e){let t=getComputedStyle(this.box),n={stroke:t.color,grid:{stroke:t.getPropertyValue("--line"),width:1},ticks:{stroke:t.getPropertyValue("--line"),width:1}};return new dn({width:Math.max(this.box.clientWidth,200),height:170,cursor:{drag:{x:!0,y:!1}},scales:{x:{time:!1}},axes:[{...n,values:(s,r)=>r.map(o=>`${o} s`)},{...n,size:52}],series:[{label:"s"},...e.map(({name:s},r)=>({label:s,stroke:eP[r]??"#888",width:1.5}))]},[[],...e.map(()=>[])],this.box)}};function fx(i){let e=tP(i),t=e.map(({curves:d})=>new ju(d)),n=!1,s=!1,r=-1/0,o=[0,1,2].map(d=>new am(e,t,d,()=>n)),a=A("select",{"aria-label":"How much time is shown"},...QC.map(d=>A("option",{value:d},`${d} s`))),l=ke("Hold",()=>{n=!n,l.setAttribute("aria-pressed",String(n)),l.textContent=n?"Go on":"Hold"},{"aria-pressed":"false"}),c=d=>()=>{n||l.click(),d()},h=A("div",{class:"tools"},a,l,ke("Zoom in",c(()=>o.forEach(d=>d.zoom(.5)))),ke("Zoom out",c(()=>o.forEach(d=>d.zoom(2))))),u=A("p",{class:"hint"},"Drag over a plot to zoom into it while it is held; a double click shows all again.");return matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>o.forEach(d=>d.makeAnew())),i.frameTakers.push(d=>t.forEach(f=>f.add(d))),{title:"Plots",content:A("div",{class:"plots"},h,...o.map(({box:d})=>d),u),show:()=>s=!0,hide:()=>s=!1,look:d=>{!s||n||d-r<JC||(r=d,o.forEach(f=>f.draw(Number(a.value))))}}}var nP=1e4,iP=1e3;function sP(i,e,t,n){let s=c=>t[c],r=t.live,o=s("names").map((c,h)=>{let u=`parameter-${e}-${c}`,d=A("input",{id:u,value:s("values")[h]??"",disabled:!r[h],spellcheck:!1,autocomplete:"off"}),f=A("form",{class:"parameter"},A("label",{for:u},c),d,A("button",{type:"submit",disabled:!r[h]},"Set"),A("small",{},s("docs")[h]??""));return f.addEventListener("submit",g=>{g.preventDefault(),i.attempt(`${e}: ${c} = ${d.value}`,async()=>{i.command.mine||await i.command.take(),await i.robot.order("/plugins/set_parameter",{plugin:e,parameter:c,value:d.value})}).then(n)}),{change:f,live:r[h]??!1}}),a=o.filter(c=>!c.live).map(c=>c.change),l=o.filter(c=>c.live).map(c=>c.change);return A("div",{},...l,A("details",{},A("summary",{},`${a.length} that hold until a restart`),...a))}function rP(i,e,t){let n=e.steps-i.steps,s=n>0?(t-i.seen_s)*1e3/n:NaN;he(i.state,e.state),i.box.classList.toggle("bad-card",e.state!=="works"),i.facts.set("period",Number.isNaN(s)?"–":`${s.toFixed(1)} ms`),i.facts.set("p50",`${e.p50_step_us.toFixed(0)} µs`),i.facts.set("p99",`${e.p99_step_us.toFixed(0)} µs`),i.facts.set("worst",`${e.worst_step_us.toFixed(0)} µs`),i.facts.set("faults",String(e.faults),e.faults>0),i.facts.set("over budget",String(e.overruns),e.overruns>0)}function px(i){let{robot:e,attempt:t,command:n,news:s,freshness:r}=i,o=A("div"),a=A("section",{"aria-label":"Parameters",hidden:!0}),l=new Map,c=-1/0,h=async m=>{let p=await e.order("/plugins/get_parameters",{plugin:m},nP);a.hidden=!1,a.replaceChildren(A("h2",{tabindex:-1},`Parameters of ${m}`),sP(i,m,p,()=>u(m)))},u=m=>void h(m).catch(p=>s.say(p.message,"bad")),d=m=>void h(m).then(()=>a.querySelector("h2")?.focus(),p=>s.say(p.message,"bad")),f=m=>void t(`Reload ${m}`,async()=>{n.mine||await n.take(),await e.order("/plugins/reload",{name:m,library:""},1e4)}),g=({name:m,steps:p},M)=>{let b=A("span",{class:"plugin-state"}),_=new mi,I=A("article",{class:"card","aria-label":m},A("header",{},A("h2",{},m),b,ke("Parameters",()=>d(m),{"aria-label":`Parameters of ${m}`}),ke("Reload",()=>f(m),{"aria-label":`Reload ${m}`})),_.list);o.append(I);let R={box:I,state:b,facts:_,steps:p,seen_s:M};return l.set(m,R),R},v=async()=>{let{plugins:m}=await e.order("/plugins/list"),p=r.newest?.robot_time[0]??0;for(let M of m){let b=l.get(M.name)??g(M,p);M.steps<b.steps&&Object.assign(b,{steps:M.steps,seen_s:p}),rP(b,M,p)}};return{title:"Plug-ins",content:A("div",{class:"plugins"},o,a),look:m=>{!e.isOpen||m-c<iP||(c=m,v().catch(p=>s.say(p.message,"bad")))}}}function oP(i){return i<1e6?`${Math.ceil(i/1e3)} kB`:`${(i/1e6).toFixed(1)} MB`}var aP=1e3;function mx({robot:i,attempt:e,news:t}){let n=A("input",{id:"recording-name",placeholder:"named by the time",pattern:"[A-Za-z0-9_.\\-]*",maxlength:100}),{table:s,body:r}=Oi("Recordings (MCAP), the newest first","file","size","begun"),o=A("p",{class:"hint path"}),a=new Map,l=-1/0,c=({file:m,bytes:p})=>{let M=a.get(m);return a.set(m,p),`${oP(p)}${M!==void 0&&p>M?", recording":""}`},h=async()=>{l=performance.now();let m=await i.order("/recording/list"),p=m.recordings;r.replaceChildren(...p.map(b=>Ml(A("span",{class:"path",title:b.file},b.file.split("/").pop()??b.file),c(b),new Date(b.start.sec*1e3).toLocaleString())));let M=p[0]?.file.replace(/\/[^/]*$/,"");he(o,M===void 0?"There are none yet.":`On the robot's computer, in ${M}. ${m.message}`)},u=()=>void h().catch(m=>t.say(m.message,"bad")),d=()=>void e("Recording",()=>i.order("/recording/start",{name:n.value}),"begun").then(u),f=ke("Record",d),g=ke("End the recording",()=>void e("Recording",()=>i.order("/recording/stop",{},1e4),"ended").then(u));return n.addEventListener("keydown",m=>m.key==="Enter"&&d()),{title:"Recordings",content:A("div",{class:"recordings"},A("div",{class:"tools"},A("label",{for:"recording-name"},"Name"),n,f,g),s,o),show:u,look:m=>{i.isOpen&&m-l>aP&&h().catch(()=>{})}}}async function yx(i){let e=await fetch("bus.json",Qi(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var lP=2147483648,cP=1073741824,hP=536870912;function uP(i){return`0x${i.toString(16).toUpperCase().padStart(3,"0")}`}function vx(i,e){return i.joint<0?i.kind:`${i.kind}, ${e[i.joint]??`joint ${i.joint}`}`}function dP(i){return`unknown ${(i&lP)!==0?"extended ":""}${(i&cP)!==0?"remote ":""}frame ${uP(i&536870911)}`}var lm=class{constructor(e,t,n){this.slot=e;this.table=t;this.frames=n;this.sync=n.find(({message:s})=>s.released==="slot_edge")}sync;ofMissing(e){if(e.released==="slot_edge")return 0;if(e.released==="sync")return this.sync?.end_us??this.table.messages.find(({released:t})=>t==="slot_edge")?.worst_us??void 0}of(e){let{message:t,start_us:n}=e;switch(t.released){case"sync":return this.answersNothingHere(e)?void 0:this.ofMissing(t);case"cycle_edge":return this.slot.slot===0?0:void 0;case"batch":return this.frames.find(s=>s.message.released==="batch"&&gx(s)===gx(e))?.start_us;case"trajectory":return this.frames.findLast(s=>s.message.joint===t.joint&&s.message.released==="cycle_edge"&&s.end_us<=n)?.end_us;default:return this.ofMissing(t)}}answersNothingHere({start_us:e}){return this.sync!==void 0&&e<this.sync.end_us}isOfSlotBefore(e){return e.message.released==="sync"&&this.answersNothingHere(e)&&this.frames.some(t=>t.message===e.message&&t.end_us>e.end_us)}};function gx({message:i,id:e}){return i.ids.indexOf(e)}function fP(i,e,t){let{message:n,end_us:s,start_us:r}=i,o=e.of(i),a=o===void 0||n.worst_us===null?void 0:o+n.worst_us,c=e.isOfSlotBefore(i)||a!==void 0&&s>a?"late":a===void 0?"seen":"in time";return{message:n,name:vx(n,t),verdict:c,end_us:s,length_us:s-r,...o!==void 0&&{due_us:o},...a!==void 0&&{latest_us:a}}}function pP(i,e){return!i.on_event&&i.period_us===e.slot_us&&(i.released==="slot_edge"||i.released==="sync")}function _x(i,e,t){let n=new Map(e.messages.flatMap(u=>u.ids.map(d=>[d,u]))),s=[],r=[],o=0;for(let[u,d]of i.id.entries()){let[f,g]=[i.end_us[u]??0,i.length_us[u]??0],v=n.get(d);if((d&hP)!==0){s.push({name:"error on the bus",verdict:"error",end_us:f,length_us:0});continue}o+=Math.min(g,f)+e.interframe_us,v?r.push({message:v,id:d,start_us:f-g,end_us:f}):s.push({name:dP(d),verdict:"foreign",end_us:f,length_us:g})}r.sort((u,d)=>u.end_us-d.end_us);let a=new lm(i,e,r);s.push(...r.map(u=>fP(u,a,t)));let l=new Set(r.filter(u=>!a.isOfSlotBefore(u)).map(({message:u})=>u));for(let u of i.left_out>0?[]:e.messages){let d=a.ofMissing(u);l.has(u)||d===void 0||!pP(u,e)||s.push({message:u,name:vx(u,t),verdict:"missing",length_us:u.transmission_us,due_us:d,...u.worst_us!==null&&{latest_us:d+u.worst_us}})}let c=({end_us:u,due_us:d})=>u??d??0;s.sort((u,d)=>c(u)-c(d));let h={"in time":0,seen:0,late:0,missing:0,foreign:0,error:0};for(let{verdict:u}of s)h[u]+=1;return{entries:s,load:Math.min(o/e.slot_us,1),count:h}}function cm({entries:i,load:e}){return`${i.filter(({end_us:n,verdict:s})=>n!==void 0&&s!=="error").length} frames take ${Math.round(e*100)} % of the slot`}function hm({entries:i,count:e}){let t=s=>{let r=i.filter(o=>o.verdict===s).map(({name:o})=>o);return r.length>2?`${r.slice(0,2).join("; ")} …`:r.join("; ")},n=[e.missing>0&&`${e.missing} missing (${t("missing")})`,e.late>0&&`${e.late} late (${t("late")})`,e.error>0&&`${e.error} ${e.error===1?"error":"errors"}`,e.foreign>0&&`${e.foreign} not the robot's own (${t("foreign")})`].filter(s=>s!==!1);return n.length>0?n.join(", "):"none is missing or late"}var xx=({count:i})=>i.missing+i.late+i.error+i.foreign>0;var ii=14,mP=18,gP=5.7,bx=22,yP=12,vP=280,_P=2e3,wx=1500,xP={SYNC:"sync",trim:"trim",feedback:"feedback",trajectory:"trajectory"},bP=[["sync","SYNC"],["trim","trim"],["feedback","feedback"],["trajectory","trajectory"],["other","other"],["due","due"],["latest","proven latest"],["late","late"],["missing","missing"],["error","error"],["foreign","foreign"]];function gi(i,e,t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,typeof r=="number"?String(Math.round(r*10)/10):r);return t!==void 0&&(n.textContent=t),n}var Ju=i=>i===void 0?"–":(i/1e3).toFixed(2);function wP({name:i,verdict:e,end_us:t,length_us:n,latest_us:s}){let r=t===void 0?"has not come":`at ${Ju(t)} ms`;return[`${i}: ${r}`,n>0&&t!==void 0&&`${n} µs long`,s!==void 0&&`at the latest ${Ju(s)} ms`,e!=="seen"&&e].filter(Boolean).join(", ")}var Qu=class{constructor(e,t){this.bus=e;this.joints=t;let n=[...new Set(e.messages.map(({joint:a})=>a).filter(a=>a>=0))].sort((a,l)=>a-l);for(let[a,l]of n.entries())this.jointLane.set(l,a+1);this.lanes=["all joints",...n.map(a=>t[a]??""),"others, errors"].map(a=>a.length>bx?`${a.slice(0,bx-1)}…`:a),this.label_px=Math.max(...this.lanes.map(({length:a})=>a))*gP+10;let{table:s,body:r}=Oi("Frames of the slot; times in ms from its edge","frame","end","µs","at the latest","");s.classList.add("bus-table"),this.rows=r,this.details=A("details",{},A("summary",{},"The slot as a table"),s),this.details.addEventListener("toggle",()=>this.fillTable()),this.box.append(this.drawing);let o=A("ul",{class:"bus-legend","aria-hidden":!0},...bP.map(([a,l])=>A("li",{class:a},l)));this.content=A("div",{},A("div",{class:"tools"},this.hold,this.status),this.box,this.verdict,o,A("p",{class:"note"},this.note()),this.details),new ResizeObserver(()=>this.draw()).observe(this.box)}drawing=gi("svg",{role:"img"});status=A("p",{class:"bus-status"});verdict=A("p",{class:"bus-verdict"});hold=ke("Hold",()=>this.toggle());rows;details;lanes;label_px;jointLane=new Map;box=A("div",{class:"bus-picture"});shown;slot;held=!1;content;take(e){this.held||(this.slot=e,this.shown=_x(e,this.bus,this.joints),he(this.verdict,hm(this.shown)),this.verdict.classList.toggle("bad",xx(this.shown)),this.draw(),this.fillTable())}look(e,t){if(!this.slot||!this.shown){he(this.status,"No slot has come yet.");return}let{sec:n,nanosec:s}=this.slot.header.stamp,r=e-n*1e3-s/1e6,o=r<-wx?NaN:Math.max(r,0),a=!t||Number.isNaN(o)||o>wx;this.box.classList.toggle("old",a&&!this.held);let l=this.held?"held, ":a?"old: ":"";he(this.status,`Slot ${this.slot.slot} of cycle ${this.slot.cycle}, ${l}${Number.isNaN(o)?"of unknown age":`${Nn(o)} ago`}. ${cm(this.shown)}.`)}note(){let{profile:e,load:t,jitter_us:n,jam_us:s}=this.bus;return`One slot of 25. Proven for the profile '${e}': load ${Math.round(t*100)} % at most; latest arrivals with senders up to ${n/1e3} ms late and the bus jammed once for ${s/1e3} ms.`}toggle(){this.held=!this.held,this.hold.setAttribute("aria-pressed",String(this.held))}laneOf({message:e}){return e?e.joint<0?0:this.jointLane.get(e.joint)??this.lanes.length-1:this.lanes.length-1}draw(){let e=Math.max(this.box.clientWidth,vP);if(!this.shown||this.box.clientWidth===0)return;let t=this.lanes.length*ii+mP,{slot_us:n}=this.bus,s=r=>this.label_px+Math.min(Math.max(r,0),n)/n*(e-this.label_px-yP);this.drawing.setAttribute("viewBox",`0 0 ${e} ${t}`),this.drawing.setAttribute("height",String(t)),this.drawing.setAttribute("aria-label",`${cm(this.shown)}: ${hm(this.shown)}`),this.drawing.replaceChildren(...this.ground(s,e),...this.dueLine(s),...this.shown.entries.flatMap(r=>this.marks(r,s)))}ground(e,t){let n=this.lanes.length*ii,s=this.lanes.flatMap((r,o)=>[gi("rect",{class:o%2===0?"lane even":"lane",x:0,y:o*ii,width:t,height:ii}),gi("text",{x:this.label_px-6,y:(o+1)*ii-3.5,"text-anchor":"end"},r)]);for(let r=0;r<=this.bus.slot_us;r+=_P)s.push(gi("line",{class:"grid",x1:e(r),x2:e(r),y1:0,y2:n}),gi("text",{x:r===this.bus.slot_us?t:e(r),y:n+13,"text-anchor":r===this.bus.slot_us?"end":"middle"},`${r/1e3}${r===this.bus.slot_us?" ms":""}`));return s}dueLine(e){let t=this.shown?.entries.find(({message:n,due_us:s})=>n?.released==="sync"&&s!==void 0)?.due_us;return t===void 0?[]:[gi("line",{class:"due",x1:e(t),x2:e(t),y1:ii,y2:(this.lanes.length-1)*ii})]}marks(e,t){let{message:n,verdict:s,end_us:r,length_us:o,due_us:a,latest_us:l}=e,c=this.laneOf(e)*ii,h=[];return l!==void 0&&l<=this.bus.slot_us&&h.push(gi("line",{class:"latest",x1:t(l),x2:t(l),y1:c+1,y2:c+ii-1})),r===void 0?h.push(gi("text",{class:"missing",x:t(a??0)+4,y:c+ii-3.5},"✕ missing")):s==="error"?h.push(gi("text",{class:"error",x:t(r),y:c+ii-3,"text-anchor":"middle"},"◆")):h.push(...this.block(t(r-o),t(r),c,s,n)),h.at(-1)?.append(gi("title",{},wP(e))),h}block(e,t,n,s,r){let o=s==="foreign"?"foreign":xP[r?.kind??""]??"other",a=gi("rect",{class:`frame ${o}${s==="late"?" late":""}`,x:e,y:n+2,width:Math.max(t-e,1.5),height:ii-4});return s!=="late"?[a]:[gi("text",{class:"late",x:e-2,y:n+ii-3.5,"text-anchor":"end"},"late"),a]}fillTable(){!this.details.open||!this.shown||this.rows.replaceChildren(...this.shown.entries.map(e=>{let{name:t,end_us:n,length_us:s,latest_us:r,verdict:o}=e,a=Ml(t,Ju(n),n===void 0?"–":String(s),Ju(r),o);for(let l of[1,2,3])a.cells[l]?.classList.add("number");return a.classList.toggle("bad",o!=="in time"&&o!=="seen"),a}))}};async function Mx(i){let e=await fetch("calibration.json",Qi(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var ed=i=>i*180/Math.PI,MP=(i,e)=>(i<0?"−":"+")+Math.abs(i).toFixed(e),SP="as described";function um(i,e,t,n){if(!i)return SP;let s=i.deviation?.[e];return MP(t(i.value[e]??NaN),n)+(s===void 0?"":` ± ${t(s).toFixed(n)}`)}var Sx=i=>um(i,0,ed,3),Tx=(i,e)=>um(i,e,t=>t*1e3,1),Ex=(i,e)=>um(i,e,t=>t,3).replace(/^\+/,"");function Ax([i,e,t,n]){let s=2*(n*e-t*i),r=Math.abs(s)>1-1e-9,o=r?0:Math.atan2(2*(n*i+e*t),1-2*(i*i+e*e)),a=Math.asin(Math.min(1,Math.max(-1,s))),l=r?-2*Math.sign(s)*Math.atan2(i,n):Math.atan2(2*(n*t+i*e),1-2*(e*e+t*t));return[ed(o),ed(a),ed(l)].map(c=>Math.abs(c)<5e-4?0:c)}function Rx({there:i,made:e}){return i?e===null?"Calibrated; its file does not say when.":`Calibrated, made ${e.replace("T"," ").replace(/:\d\dZ$/," UTC")}.`:"This robot has no calibration: zeros, centre of mass and gains are taken to be as its description says. gaitway calibrate finds them."}var TP=["front left","front right","rear left","rear right"],dm=i=>A("th",{scope:"row"},i),fl=i=>A("td",{class:"number"},i);function EP({joints:i}){let{table:e,body:t}=Oi("Joint zeros: what an encoder says where its joint is at 0","joint","zero, °","trim channel");e.classList.add("zeros");for(let{name:n,zero:s,trim_channel:r}of i)t.append(A("tr",{},dm(n.replaceAll("_"," ")),fl(Sx(s)),fl(r===null?"–":String(r))));return e}function AP({feet:i}){if(i.every(({sensor:n})=>n!=="cells"))return A("p",{class:"hint"},"Its feet have no force cells.");let{table:e,body:t}=Oi("Force cells: reading over force; each is taken to read 0 N without load","cell","left","right");e.classList.add("gains");for(let[n,s]of TP.entries())t.append(A("tr",{},dm(s),...i.map(({gain:r,sensor:o})=>fl(o==="cells"?Ex(r,n):"–"))));return e}function RP({trunk_com_offset:i,imu:e}){let{table:t,body:n}=Oi(`Trunk and IMU (in ${e.link})`,"axis","centre of mass off by, mm","IMU turned by, °");t.classList.add("trunk");let s=Ax(e.turn);for(let[r,o]of["x, roll","y, pitch","z, yaw"].entries())n.append(A("tr",{},dm(o),fl(Tx(i,r)),fl((s[r]??NaN).toFixed(2))));return t}function Cx({token:i,news:e}){let t=A("div"),n=A("details",{class:"calibration"},A("summary",{},"Calibration"),t),s=!1;return n.addEventListener("toggle",()=>{!n.open||s||(s=!0,Mx(i()).then(r=>t.replaceChildren(A("p",{},Rx(r)),EP(r),AP(r),RP(r)),r=>{s=!1,n.open=!1,e.say(`The calibration does not come: ${r.message}`,"bad")}))}),n}function CP(i){let{table:e,body:t}=Oi("Joints","joint","position, °","torque, N·m","faults");e.classList.add("joints");let n=i.description.joints.map(({name:s})=>{let[r,o]=[A("td",{class:"number"}),A("td",{class:"number"})],a=A("td"),l=A("tr",{},A("th",{scope:"row"},s.replaceAll("_"," ")),r,o,a);return t.append(l),{row:l,position:r,torque:o,faults:a}});return{table:e,joints:n}}function PP({freshness:i},e,t,n,s){let r=i.newest;if(!r)return;n.set("late",String(r.batches_late[0]),(r.batches_late[0]??0)>0),n.set("refused",String(r.batches_refused[0]),(r.batches_refused[0]??0)>0),n.set("cycles from a safe tail",String(r.tails_played[0])),n.set("robot's clock",`${(r.robot_time[0]??0).toFixed(1)} s`);for(let[c,h]of El.entries()){let u=i.age_ms(c,t);s.set(h,Nn(u),c!==3&&u>300)}s.set("way there and back",Number.isNaN(r.round_trip[0])?"–":Nn((r.round_trip[0]??0)*1e3));let{frames:o,outages:a,longest_ms:l}=i.loss;s.set("lost by this page",`${o} frames, ${a} outages${a>0?`, the longest ${Nn(l)}`:""}`,a>0),s.set("pictures",`${e.pace.perSecond} /s, ${e.pace.total} in all`)}function IP(i){let{robot:e,freshness:t,description:n}=i,s=A("div",{},A("p",{class:"note"},"The robot is asked what its bus is meant to carry.")),r,o,a=async()=>{try{r=new Qu(await yx(i.token()),n.joints.map(({name:l})=>l.replaceAll("_"," "))),s.replaceChildren(r.content)}catch(l){s.replaceChildren(A("p",{class:"note bad"},`What the bus is meant to carry does not come: ${l.message}`)),o=void 0}};return{content:s,show:()=>{let[l,c]=[!0,()=>{}];return o??=a(),o.then(()=>{r&&l&&(c=e.subscribe("/bus_slot","gaitway_msgs/msg/BusSlot",0,h=>r?.take(h)))}),()=>{l=!1,c()}},look:l=>r?.look((t.newest?.robot_time[0]??NaN)*1e3+t.age_ms(4,l),t.state(l)==="live")}}function Px(i,e){let{robot:t,freshness:n,description:s}=i,[r,o,a]=[new mi,new mi,new mi],l=IP(i),{table:c,joints:h}=CP(i),u=A("div",{class:"state"},A("h2",{},"Batches"),r.list,A("h2",{},"Age of what is shown"),o.list,A("h2",{},"Bus"),a.list,A("h2",{},"A time slot on the bus"),l.content,c,Cx(i)),d=new Map,f=[],g=m=>{for(let[p,M]of m.effort.entries()){let b=Math.abs(M)/(s.joints[p]?.torque??1/0),_=h[p]?.torque;_&&(he(_,M.toFixed(2)),_.classList.toggle("bad",b>.95))}},v=m=>{let p=m.status;d=new Map(p.find(({name:I})=>I==="nodes")?.values.map(({key:I,value:R})=>[I,R]));let{message:M="",level:b=0,values:_=[]}=p.find(({name:I})=>I==="bus")??{};a.set("state",M,b>0);for(let{key:I,value:R}of _)(R!=="0"||I.endsWith("_errors"))&&a.set(I.replaceAll("_"," "),R)};return{title:"State",content:u,show:()=>{f=[t.subscribe("/joint_states","sensor_msgs/msg/JointState",250,g),t.subscribe("/diagnostics","diagnostic_msgs/msg/DiagnosticArray",0,v),l.show()]},hide:()=>f.forEach(m=>m()),look:m=>{PP(i,e,m,r,o),l.look(m);for(let[p,M]of h.entries()){let b=n.newest?.joint[p];he(M.position,b===void 0?"–":(b*180/Math.PI).toFixed(1));let _=n.newest!==void 0&&zm(n.newest,p);he(M.faults,_?d.get(s.joints[p]?.name??"")??"fault":""),M.row.classList.toggle("bad",_)}}}}function Ix(i){let e=tt("token"),t=tt("token-text");return he(tt("token-why"),i),t.value="",new Promise(n=>{e.oncancel=s=>s.preventDefault(),e.onclose=()=>{t.value===""?e.showModal():n(t.value.trim())},e.showModal(),t.focus()})}var pl="63fb982c7b506aef";async function Lx(){let i=await fetch("version.json",{cache:"no-store",signal:AbortSignal.timeout(2e3)});if(i.status===404)return"";if(!i.ok)throw new Error(await i.text());return String((await i.json()).page??"")}function kx(i){let e=i===""?"an older page, without a version":`page ${i}`;return`This page is of another version than the robot's software: this is page ${pl}, the robot has ${e}. It is not understood any more: load the page again. Stop still works.`}var LP="the token is wrong",td=class{constructor(e,t,n){this.freshness=t;this.token=n;this.keeper=new Xr(`${e}?page=${pl}`,this)}keeper;since_ms=performance.now();open=!1;onFrame=()=>{};onWrongToken=()=>{};onWrongVersion=()=>{};start(){this.keeper.start(),setInterval(()=>this.look(),1e3/4)}opened(e){this.open=!0,this.since_ms=performance.now();let t=this.token();t!==void 0&&e.send(t)}closed(e){this.open||this.askForVersion(),this.open=!1,e===LP&&(this.keeper.stop(),this.onWrongToken()),this.freshness.disconnected(performance.now())}received(e){try{let t=Om(e);this.keeper.send(Bm(t)),this.since_ms=performance.now(),this.freshness.take(t,this.since_ms),this.onFrame(t)}catch(t){if(!(t instanceof jo))throw t;this.endFor(`${t.message}: load the page again. Stop still works.`)}}async askForVersion(){let e=await Lx().catch(()=>pl);e!==pl&&this.endFor(kx(e))}endFor(e){this.keeper.stop(),this.onWrongVersion(e)}look(){this.open&&performance.now()-this.since_ms>1e3&&this.keeper.restart("nothing came")}};var kP=100,DP=500,Fr;async function NP(i){for(;;)try{return await Km(Fr)}catch(e){if(e instanceof Jo){Fr=await Ix(Fr===void 0?"Whoever serves it can tell you.":"That was not the right one.");continue}i.say(`The robot's description does not come: ${e.message}`,"bad"),await new Promise(t=>setTimeout(t,DP))}}function FP(i){return async(e,t,n="done")=>{try{return await t(),i.say(`${e}: ${n}`,"good",e),!0}catch(s){let r=s instanceof Qs?" Look whether it was carried out: it is not sent again.":"";return i.say(`${e}: ${s.message}${r}`,"bad",e),!1}}}function UP(i,e,t,n,s,r,o){let{freshness:a,robot:l,news:c,description:h}=i,u=new td(yd("/view"),a,()=>Fr),d=new Al(i),f=new qu(tt("tabs"),tt("panels"),o);i.frameTakers.push(b=>t.show(b),b=>r.show(b)),u.onFrame=b=>i.frameTakers.forEach(_=>_(b));let g=new Fl(l),v=new Rl(i),p=h.bounds.push!==void 0?j_(i,{scene:t,canvas:n,tools:s,driver:e,tabs:f,stops:r,banner:g}):void 0;u.onWrongVersion=b=>{e.retire();for(let _ of["top","camera","panel"])tt(_).inert=!0;g.otherVersion(b)},u.onWrongToken=()=>location.reload(),l.onClose=()=>e.lost(),l.onStatus=(b,_)=>{if(b==="error"&&Ym(_)){e.late(performance.now());return}b==="error"&&i.drive.end(),!Zm(_)&&c.say(b==="error"?`What you asked for was not done: ${_}`:_,b==="error"?"bad":"plain")},setInterval(()=>{let b=performance.now();d.look(b),g.look(b),v.look(b),f.look(b),p?.(b),t.setOld(a.state(b)!=="live")},kP),u.start(),l.start()}async function OP(){let i=new Ul(tt("news")),e=await NP(i),t=tt("scene"),n=new zh(t,e);n.onDrawn=()=>{performance.getEntriesByName("first-picture").length===0&&performance.mark("first-picture")};let s=new Cl(yd("/"),()=>Fr),r=`page ${crypto.getRandomValues(new Uint16Array(1))[0]?.toString(16).padStart(4,"0")}`,o={description:e,freshness:new Sl,robot:s,command:new Pl(s,r),drive:new Il,news:i,token:()=>Fr,frameTakers:[],attempt:FP(i)},a=new Nl(o),l=new Xu(o,()=>a.end());a.pad.onStop=()=>l.stop();let{push:c}=e.bounds,h=new Ol,u=c&&new Bl(o,n,t,c,h);u&&h.add(u),Wm(tt("camera"),n,u);let d=[cx(o,a),Px(o,n),ex(o),fx(o),dx(o),px(o),mx(o)];UP(o,a,n,t,h,l,d),await n.body.loadMeshes(Fr,()=>n.ask())}OP();})();
