"use strict";(()=>{function O(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r===void 0||r===!1||n.setAttribute(s,r===!0?"":String(r));return n.append(...t),n}function Qe(i,e,t={}){let n=O("button",{type:"button",...t},i);return n.addEventListener("click",e),n}function ft(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element '${i}'`);return e}function Be(i,e){i.textContent!==e&&(i.textContent=e)}function al(...i){return O("tr",{},...i.map(e=>O("td",{},e)))}function Ui(i,...e){let t=O("tbody"),n=O("thead",{},O("tr",{},...e.map(s=>O("th",{scope:"col"},s))));return{table:O("table",{},O("caption",{},i),n,t),body:t}}function qs(i){return i instanceof HTMLElement&&(i.isContentEditable||/^(TEXTAREA|SELECT)$/.test(i.tagName)||i instanceof HTMLInputElement&&!/^(checkbox|radio|button)$/.test(i.type))}function Np(i,e,t){let n=Qe("Follow",()=>{e.follows=!e.follows,n.setAttribute("aria-pressed",String(e.follows))},{"aria-pressed":"true",title:"The camera goes with the robot"}),s=["behind","front","side","top"];i.append(n,...s.map(r=>Qe(r[0]?.toUpperCase()+r.slice(1),()=>e.lookFrom(r),{title:`Look from ${r}`})),Qe("+",()=>e.zoom(.8),{"aria-label":"Nearer"}),Qe("−",()=>e.zoom(1.25),{"aria-label":"Farther"}),...t?[t.toggle,t.form]:[])}var kp=[700,700,2500],zr=class{constructor(e,t){this.url=e;this.user=t}socket;timer;tries=0;ended=!1;start(){this.ended=!1,this.tryOnce()}stop(){this.ended=!0,this.drop("")}restart(e){this.drop(e),this.ended||(this.timer=setTimeout(()=>this.tryOnce(),200))}send(e){return this.socket?.readyState!==WebSocket.OPEN?!1:(this.socket.send(e),!0)}tryOnce(){clearTimeout(this.timer);let e=new WebSocket(this.url);e.binaryType="arraybuffer",this.socket=e,this.timer=setTimeout(()=>this.restart("no answer"),kp[this.tries++%kp.length]),e.onopen=()=>{clearTimeout(this.timer),this.tries=0,this.user.opened(e)},e.onmessage=t=>this.user.received(t.data),e.onclose=t=>this.restart(t.reason)}drop(e){clearTimeout(this.timer);let t=this.socket;this.socket=void 0,t&&(t.onopen=t.onmessage=t.onclose=null,t.close(),this.user.closed(e))}};function Cu(i){return`${location.protocol==="https:"?"wss":"ws"}://${location.host}${i}`}var Ys=class extends Error{},Xn=class extends Error{};function Op(i){return i.includes("late: it may have been sent")}function Bp(i){return i.includes("given before a stop")||i.includes("a stop that this connection called later")}var Fp=3e3,Up=1e3,Nx=20,ll=class{constructor(e,t){this.token=t;this.keeper=new zr(e,this)}keeper;waiting=new Map;subscriptions=new Map;lastId=0;open=!1;onOpen=()=>{};onClose=()=>{};onStatus=()=>{};start(){this.keeper.start(),setInterval(()=>void this.probe(),Up)}get isOpen(){return this.open}call(e,t={},n=Fp){return new Promise((s,r)=>{let o=`${e}#${++this.lastId}`;if(!this.keeper.send(JSON.stringify({op:"call_service",id:o,service:e,args:t}))){r(new Xn(`${e} was not sent: there is no connection to the robot`));return}let a=setTimeout(()=>{this.waiting.delete(o),r(new Ys(`${e} was sent, but not answered within ${n/1e3} s`))},n);this.waiting.set(o,{service:e,resolve:s,reject:r,timer:a})})}async order(e,t={},n=Fp){let s=await this.call(e,t,n);if(!s.success)throw new Xn(s.message||`${e} was refused`);return s}async stop(e,t={}){let n=this.order(e,t),s=JSON.stringify({op:"call_service",id:`${e}#${this.lastId}`,service:e,args:t}),r=setInterval(()=>this.keeper.send(s),Nx);try{return await n}finally{clearInterval(r)}}publish(e,t){return this.keeper.send(JSON.stringify({op:"publish",topic:e,msg:t}))}subscribe(e,t,n,s){let r=this.subscriptions.get(e);r||(r={type:t,throttle_ms:n,takers:new Set},this.subscriptions.set(e,r),this.sendSubscription(e,r));let{takers:o}=r;return o.add(s),()=>{o.delete(s),!(o.size>0||!this.subscriptions.delete(e))&&this.keeper.send(JSON.stringify({op:"unsubscribe",topic:e}))}}opened(){this.open=!0;let e=this.token();e!==void 0&&this.keeper.send(JSON.stringify({op:"auth",token:e}));for(let[t,n]of this.subscriptions)this.sendSubscription(t,n);this.onOpen()}closed(){let e=[...this.waiting.values()];this.waiting.clear();for(let{service:t,reject:n,timer:s}of e)clearTimeout(s),n(new Ys(`${t} was sent, but the connection was lost before its answer`));this.open&&this.onClose(),this.open=!1}received(e){let t=JSON.parse(e);if(t.op==="publish")for(let n of this.subscriptions.get(t.topic)?.takers??[])n(t.msg);else t.op==="service_response"?this.answered(t):t.op==="status"&&this.onStatus(String(t.level),String(t.msg))}answered(e){let t=e.id,n=this.waiting.get(t);n&&(this.waiting.delete(t),clearTimeout(n.timer),e.result===!0?n.resolve(e.values):n.reject(new Xn(String(e.values))))}sendSubscription(e,{type:t,throttle_ms:n}){this.keeper.send(JSON.stringify({op:"subscribe",topic:e,type:t,throttle_rate:n,queue_length:n?1:100}))}async probe(){if(this.open)try{await this.call("/rosapi/get_time",{},Up)}catch(e){e instanceof Ys&&this.open&&this.keeper.restart("no answer")}}};var cl=class{constructor(e,t){this.robot=e;this.name=t}name;lease;period_ms=0;kept_ms=0;asking;onChange=()=>{};get mine(){return this.lease!==void 0}take(){return this.asking??=this.ask().finally(()=>this.asking=void 0),this.asking}async giveBack(){let e=this.lease;this.lost(),e!==void 0&&await this.robot.order("/command/release",{lease:e})}lost(){this.lease!==void 0&&(this.lease=void 0,this.onChange())}async keep(e){let t=this.lease;if(!(t===void 0||e-this.kept_ms<this.period_ms)){this.kept_ms=e;try{await this.robot.order("/command/keep_alive",{lease:t})}catch(n){throw this.lease===t&&n instanceof Xn&&this.lost(),n}}}async ask(){let e=await this.robot.order("/command/acquire",{name:this.name});this.lease=String(e.lease),this.period_ms=Number(e.keep_alive_period)*1e3/2,this.kept_ms=performance.now(),this.onChange()}};var zo=class extends Error{};function Ji(i){return i===void 0?{}:{headers:{Authorization:`Bearer ${i}`}}}async function zp(i){let e=await fetch("robot.json",Ji(i));if(e.status===401)throw new zo(await e.text());if(!e.ok)throw new Error(await e.text());return await e.json()}var xs={forward:0,left:0,turn:0},kx=80,Fx=400;function Pu(i){return i.forward===0&&i.left===0&&i.turn===0}function Hp(i,e){let t=s=>Math.max(-1,Math.min(1,s)),n=t(i.ahead);return{forward:n*(n<0?e.backward:e.forward),left:t(i.left)*e.left,turn:t(i.turn)*e.turn}}var hl=class{current="rests";wanted=xs;sent_ms=-1/0;late_ms=-1/0;lateSince_ms=-1/0;get state(){return this.current}hold(e,t){return this.wanted=e,this.current!=="rests"||Pu(e)?!1:(this.current=t?"drives":"waits",this.sent_ms=-1/0,!t)}granted(){this.current==="waits"&&(this.current="drives")}letGo(){let e=this.current==="drives";return this.current="rests",this.wanted=xs,e?xs:void 0}end(){let e=this.current==="drives";return this.current!=="rests"&&(this.current="blocked"),e}late(e,t){return e-this.late_ms>Fx&&(this.lateSince_ms=e),this.late_ms=e,e-this.lateSince_ms>=t&&this.end()}due(e){if(!(this.current!=="drives"||e-this.sent_ms<kx))return this.sent_ms=e,this.wanted}};function Iu({bounds:i}){return{forward:i.forward,backward:i.forward,left:i.forward,turn:i.turn}}function Ux(i,e){let t=n=>{let s=Number(i[n]);return Number.isFinite(s)?Math.min(s,e[n]):e[n]};return{forward:t("forward"),backward:t("backward"),left:t("left"),turn:t("turn")}}async function Vp(i,e){return Ux(await i.call("/walk/limits"),Iu(e))}var Gp={KeyW:{ahead:1},ArrowUp:{ahead:1},KeyS:{ahead:-1},ArrowDown:{ahead:-1},KeyA:{turn:1},ArrowLeft:{turn:1},KeyD:{turn:-1},ArrowRight:{turn:-1},KeyQ:{left:1},KeyE:{left:-1}},Ox=.6,Lu=.15,Bx=i=>Math.abs(i)<Lu?0:(i-Math.sign(i)*Lu)/(1-Lu),ul=class{held=new Set;fast=!1;press(e){return this.fast=e.shiftKey,!(e.code in Gp)||e.ctrlKey||e.altKey||e.metaKey||qs(e.target)?!1:(this.held.add(e.code),!0)}release(e){this.fast=e.shiftKey,this.held.delete(e.code)}letGo(){this.held.clear()}get wish(){let e={ahead:0,left:0,turn:0};for(let n of this.held){let s=Gp[n];e.ahead+=s?.ahead??0,e.left+=s?.left??0,e.turn+=s?.turn??0}let t=this.fast?1:Ox;return{ahead:Math.sign(e.ahead)*t,left:Math.sign(e.left)*t,turn:Math.sign(e.turn)*t}}},Ho=class{constructor(e,t,n){this.changed=n;this.field=O("div",{class:`stick ${e}`,role:"img","aria-label":t,title:t},this.knob),this.field.addEventListener("pointerdown",s=>this.grasp(s)),this.field.addEventListener("pointermove",s=>this.move(s));for(let s of["pointerup","pointercancel","lostpointercapture"])this.field.addEventListener(s,r=>r.pointerId===this.pointer&&this.letGo())}field;knob=O("div",{class:"knob"});pointer;x=0;y=0;letGo(){this.pointer=void 0,this.place(0,0)}mirror(e,t){this.pointer===void 0&&this.draw(e,t)}grasp(e){e.button!==0||this.pointer!==void 0||(e.preventDefault(),this.pointer=e.pointerId,this.field.setPointerCapture(e.pointerId),this.move(e))}move(e){if(e.pointerId!==this.pointer)return;let t=this.field.getBoundingClientRect(),n=Math.min(t.width,t.height)/2-20,s=(e.clientX-t.left-t.width/2)/(this.field.classList.contains("wide")?t.width/2-24:n),r=this.field.classList.contains("wide")?0:-(e.clientY-t.top-t.height/2)/n,o=Math.hypot(s,r);o>1&&(s/=o,r/=o),this.place(s,r)}place(e,t){this.x=e,this.y=t,this.draw(e,t),this.changed()}draw(e,t){this.knob.style.setProperty("--x",String(e)),this.knob.style.setProperty("--y",String(-t))}},dl=class{stopHeld=!1;onStop=()=>{};get wish(){let e=navigator.getGamepads?.().find(s=>s?.connected);if(!e)return;let t=e.buttons.slice(0,4).some(s=>s.pressed);t&&!this.stopHeld&&this.onStop(),this.stopHeld=t;let n=s=>Bx(e.axes[s]??0);return{ahead:-n(1),left:-n(0),turn:-n(2)}}};function Wp(i){let e=t=>Math.abs(t.ahead)+Math.abs(t.left)+Math.abs(t.turn);return i.reduce((t,n)=>n&&e(n)>e(t)?n:t,{ahead:0,left:0,turn:0})}var Du=[{name:"version",type:"uint8",count:1,scale:1},{name:"joint_count",type:"uint8",count:1,scale:1},{name:"frame",type:"uint32",count:1,scale:0},{name:"robot_time",type:"uint32",count:1,scale:.001},{name:"mode",type:"uint8",count:1,scale:1},{name:"activity",type:"uint8",count:1,scale:1},{name:"contact",type:"uint8",count:2,scale:1},{name:"age",type:"uint16",count:5,scale:.001},{name:"round_trip",type:"uint16",count:1,scale:.001},{name:"base_place",type:"int32",count:2,scale:1e-4},{name:"base_height",type:"int16",count:1,scale:1e-4},{name:"base_turn",type:"int16",count:4,scale:3051850947599719e-20},{name:"com",type:"int16",count:3,scale:1e-4},{name:"zmp",type:"int16",count:2,scale:1e-4},{name:"planned_zmp",type:"int16",count:2,scale:1e-4},{name:"foot_force",type:"uint16",count:2,scale:.1},{name:"velocity",type:"int16",count:3,scale:.001},{name:"joint_trouble",type:"uint8",count:5,scale:0},{name:"batches_late",type:"uint16",count:1,scale:0},{name:"batches_refused",type:"uint16",count:1,scale:0},{name:"tails_played",type:"uint16",count:1,scale:0},{name:"footstep_count",type:"uint8",count:1,scale:1},{name:"footstep",type:"int16",count:12,scale:.001},{name:"commander",type:"uint8",count:16,scale:0},{name:"joint",type:"int16",count:0,scale:1e-4}];var qp={uint8:1,int16:2,uint16:2,int32:4,uint32:4},zx={uint8:255,int16:-32768,uint16:65535,int32:-2147483648,uint32:4294967295},Vo=class extends Error{};function Hx(i,e,t){switch(e){case"uint8":return i.getUint8(t);case"int16":return i.getInt16(t,!0);case"uint16":return i.getUint16(t,!0);case"int32":return i.getInt32(t,!0);case"uint32":return i.getUint32(t,!0)}}function Vx(i,e){return i.scale===0?e:e===zx[i.type]?NaN:e*i.scale}function $p(i){return Du.reduce((e,t)=>e+qp[t.type]*(t.count||i),0)}function Yp(i){let e=new DataView(i);if(e.getUint8(0)!==1)throw new Vo(`the robot shows layout ${e.getUint8(0)}, this page knows ${1}`);let t=e.getUint8(1);if(i.byteLength!==$p(t))throw new RangeError(`a view frame of ${t} joints has ${$p(t)} bytes, this one ${i.byteLength}`);let n={},s=0;for(let r of Du){let o=[];for(let a=0;a<(r.count||t);++a)o.push(Vx(r,Hx(e,r.type,s))),s+=qp[r.type];n[r.name]=o}return n}function Zp(i){let e=new Uint8Array(4);return new DataView(e.buffer).setUint32(0,i.frame[0]??0,!0),e}function fl(i){let e=i.commander.indexOf(0);return new TextDecoder().decode(Uint8Array.from(e<0?i.commander:i.commander.slice(0,e)))}function Kp(i,e){return((i.joint_trouble[e>>3]??0)>>(e&7)&1)===1}var vs={batches:0,safeTail:1,holds:2,emergencyStop:3},Jp=["not known","stands","walks","plays a motion","falls","lies"],jp=5,Qp=["plays batches","plays a safe tail","holds, waits for a batch","emergency stop"],pl=["joints","pose","message controller","plan","robot's clock"];var Gx=20,Wx=2e3,Xx=700,ml=class{constructor(e){this.context=e;this.bounds=Iu(e.description),document.addEventListener("keydown",t=>{this.keys.press(t)&&t.preventDefault(),this.look()}),document.addEventListener("keyup",t=>{this.keys.release(t),this.look()}),window.addEventListener("blur",()=>this.letGo()),window.addEventListener("pagehide",()=>this.leave()),document.addEventListener("visibilitychange",()=>document.hidden&&this.leave()),setInterval(()=>this.look(),Gx)}walk=new Ho("round","Walk: up and down ahead and back, sideways turns. Keys W, A, S, D or arrows.",()=>this.look());side=new Ho("wide","Sidestep to the left and right. Keys Q and E.",()=>this.look());pad=new dl;keys=new ul;foreignSince_ms;boundsRead_ms=-1/0;boundsKnown=!1;retired=!1;bounds;sent=xs;end(){this.context.drive.end()&&this.publish(xs)}lost(){let{drive:e,command:t,news:n}=this.context;t.mine&&n.say("The connection was lost, and with it the command.","bad"),e.end(),t.lost(),this.sent=xs}late(e){let{drive:t,news:n,description:s}=this.context;t.late(e,s.bounds.velocity_holds*1e3)&&n.say("The drive has ended: what you ask for comes too late, since the connection, or this computer, is slow. Let go of the stick first.","bad")}retire(){this.leave(),this.retired=!0}letGo(){this.keys.letGo(),this.walk.letGo(),this.side.letGo()}leave(){this.letGo(),this.end(),this.context.command.mine&&this.context.command.giveBack().catch(()=>{})}look(){let e=this.pad.wish;if(this.retired)return;let{drive:t,freshness:n,command:s,news:r}=this.context,o=performance.now(),a={ahead:this.walk.y,turn:-this.walk.x,left:-this.side.x},l=Wp([a,this.keys.wish,document.hidden?void 0:e]);this.walk.mirror(-l.turn,l.ahead),this.side.mirror(-l.left,0);let c=this.boundsKnown?Hp(l,this.bounds):xs;if(Pu(c)){let u=t.letGo();u&&this.publish(u)}else t.hold(c,s.mine)&&s.take().then(()=>t.granted(),u=>{t.end(),r.say(`You cannot drive: ${u.message}`,"bad")});t.state==="drives"&&n.state(o)==="lost"&&(this.end(),r.say("Nothing comes from the robot any more: the drive has ended. Let go of the stick first.","bad"));let h=t.due(o);h&&this.publish(h),this.keepCommand(o),this.keepBounds(o)}publish({forward:e,left:t,turn:n}){this.sent={forward:e,left:t,turn:n},this.context.robot.publish("/cmd_vel",{linear:{x:e,y:t},angular:{z:n}})}keepCommand(e){let{command:t,freshness:n,news:s,drive:r}=this.context;if(!t.mine){this.foreignSince_ms=void 0;return}t.keep(e).catch(l=>{l instanceof Xn&&(r.end(),s.say("You do not command any more: the robot has not heard from this page in time (is this computer busy?), or somebody has stopped it.","bad"))});let o=n.newest,a=o!==void 0&&n.state(e)!=="lost"&&fl(o)!==t.name;this.foreignSince_ms=a?this.foreignSince_ms??e:void 0,!(this.foreignSince_ms===void 0||e-this.foreignSince_ms<Xx)&&(r.end(),t.lost(),s.say("You do not command any more: somebody has stopped the robot, or the connection was too slow.","bad"))}keepBounds(e){let{robot:t,description:n}=this.context;!t.isOpen||document.hidden||e-this.boundsRead_ms<Wx||(this.boundsRead_ms=e,Vp(t,n).then(s=>{this.bounds=s,this.boundsKnown=!0},()=>{}))}};var gl=class{frame;came_ms=-1/0;connected=!1;outageSince_ms;pace=1;loss={frames:0,outages:0,longest_ms:0};take(e,t){this.endOutage(t);let n=this.frame?(e.frame[0]??0)-(this.frame.frame[0]??0)-1:0;this.connected&&n>0&&(this.loss.frames+=n),this.connected=!0,this.frame=e,this.came_ms=t}disconnected(e){this.connected&&this.beginOutage(e),this.connected=!1}get newest(){return this.frame}age_ms(e,t){if(!this.frame)return 1/0;if(this.rests)return this.sinceCame_ms(t);let n=(this.frame.age[e]??NaN)*1e3,s=(this.frame.round_trip[0]??NaN)*1e3/2;return Number.isNaN(n)?1/0:n*Math.min(this.pace,1)+(Number.isNaN(s)?0:s)+this.sinceCame_ms(t)}get rests(){return this.pace===0}sinceCame_ms(e){return e-this.came_ms}pictureAge_ms(e){return Math.max(...[0,1,2,4].map(t=>this.age_ms(t,e)))}state(e){return!this.connected||this.sinceCame_ms(e)>1e3?"lost":this.pictureAge_ms(e)>300?"old":"live"}beginOutage(e){this.outageSince_ms??=Math.min(e,Math.max(this.came_ms,0))}endOutage(e){this.frame&&this.sinceCame_ms(e)>1e3&&this.beginOutage(e),this.outageSince_ms!==void 0&&(this.loss.outages+=1,this.loss.longest_ms=Math.max(this.loss.longest_ms,e-this.outageSince_ms),this.outageSince_ms=void 0)}};function oi(i){return Number.isFinite(i)?i<1e3?`${Math.max(Math.round(i),0)} ms`:i<6e4?`${(i/1e3).toFixed(1)} s`:`${Math.round(i/6e4)} min`:"never"}var Nu=i=>i===""?"":i.charAt(0).toUpperCase()+i.slice(1)+(/[.?!]$/.test(i)?"":".");function em({otherVersion:i,link:e,linkTold_ms:t,certificate:n},s){if(i!==void 0)return{text:i,weight:"bad",action:"reload"};if(e&&e.state!=="up"){let o=`For ${oi(e.seconds*1e3+s-t)}.`;return{text:`${Nu(`the robot is not there: ${e.text}`)} ${Nu(n)}`.trim(),age:o,weight:"bad",action:void 0}}let r=[e?.text??"",n].map(Nu).join(" ").trim();return r===""?void 0:{text:r,weight:"caution",action:"hide"}}var _l=class{constructor(e){this.robot=e;e.subscribe("/link_state","gaitway_msgs/msg/LinkState",0,t=>{this.known.link=t,this.known.linkTold_ms=performance.now()}),e.subscribe("/certificate_state","std_msgs/msg/String",0,t=>this.known.certificate=String(t.data)),this.button.addEventListener("click",()=>{this.known.otherVersion!==void 0?location.reload():this.hidden=this.text.textContent??""})}box=ft("trouble");text=ft("trouble-text");age=ft("trouble-age");button=ft("trouble-button");known={linkTold_ms:0,certificate:""};rests=!1;hidden="";otherVersion(e){this.known.otherVersion=e}look(e){this.robot.isOpen||delete this.known.link;let{link:t,...n}=this.known,s=em(t&&!this.rests?this.known:n,e);this.box.hidden=!s||s.action==="hide"&&s.text===this.hidden,s&&(this.box.className=`trouble ${s.weight}`,Be(this.text,s.text),Be(this.age,s.age??""),this.button.hidden=s.action===void 0,Be(this.button,s.action==="reload"?"Load again":"Hide"))}};var $x={good:4e3,plain:6e3,bad:12e3},qx=4,yl=class{constructor(e){this.list=e}say(e,t="plain",n=e){for(let r of[...this.list.children])r instanceof HTMLElement&&r.dataset.about===n&&r.remove();let s=O("p",{class:t,"data-about":n},e);for(this.list.append(s);this.list.childElementCount>qx;)this.list.firstElementChild?.remove();setTimeout(()=>s.remove(),$x[t])}};var xl=class{tools=[];before;add(...e){this.tools.push(...e)}choose(e){let t=this.tools.find(n=>n!==e&&n.on);t?.setOn(!1),this.before=t}done(e){if(!e.on)return;let{before:t}=this;e.setOn(!1),t?.setOn(!0)}};function Zs([i,e,t,n]){return Math.atan2(2*(i*e+n*t),1-2*(e*e+t*t))}function Yx(i,{least:e,most:t}){return Math.min(Math.max(i,e),t)}function tm(i,e,t,n,s){let r=Math.hypot(i,e),o=r<=6,a=Yx(o?n:r*1,s),[l,c]=o?[0,1]:[i/r,e/r];return[a*(c*t[0]+l*t[1]),a*(c*t[1]-l*t[0])]}function ku([i,e],t){let[n,s]=[Math.cos(t),Math.sin(t)];return[n*i+s*e,n*e-s*i]}function Fu([i,e]){return Math.hypot(i,e)}function nm(i,[e,t]){return{link:i,force:{x:e,y:t,z:0},duration:.1,frame:"heading"}}var Kx=900,Jx=[{text:"↑",name:"ahead",force:[1,0]},{text:"↓",name:"back",force:[-1,0]},{text:"←",name:"to its left",force:[0,1]},{text:"→",name:"to its right",force:[0,-1]}],vl=class{constructor(e,t,n,s,r){this.context=e;this.scene=t;this.canvas=n;this.bounds=s;this.tools=r;let{links:o}=e.description;this.link=O("select",{"aria-label":"Link that is pushed"},...o.map(({name:l})=>O("option",{},l))),this.newtons=O("input",{type:"number","aria-label":"Force of a push in newtons",min:Math.ceil(s.least),max:s.most,step:1,value:s.usual}),this.toggle=Qe("Push",()=>this.on?this.tools.done(this):this.setOn(!0),{"aria-pressed":"false",id:"push",title:"Push the robot: click or drag on a part of it"}),this.form=O("div",{class:"push-form",role:"group","aria-label":"Push the robot",hidden:!0},this.link,this.newtons,"N",...Jx.map(({text:l,name:c,force:h})=>Qe(l,()=>this.pushBy(h),{"aria-label":`Push ${c}`,title:`Push ${c}`}))),n.after(this.label);let a=(l,c)=>n.addEventListener(l,c,{capture:!0});a("pointerdown",l=>this.begin(l)),a("pointermove",l=>this.move(l)),a("pointerup",l=>this.end(l)),a("pointercancel",()=>this.cancel()),n.addEventListener("pointerleave",()=>this.label.hidden=!this.drag),window.addEventListener("keydown",l=>l.key==="Escape"&&this.cancel(),{capture:!0})}toggle;form;link;newtons;label=O("p",{class:"push-label",role:"status",hidden:!0});drag;shown=0;get on(){return this.toggle.getAttribute("aria-pressed")==="true"}setOn(e){e!==this.on&&(e&&this.tools.choose(this),this.toggle.setAttribute("aria-pressed",String(e)),this.form.hidden=!e,this.canvas.classList.toggle("pushes",e),!e&&(this.cancel(),this.label.hidden=!0))}begin(e){if(this.drag){this.cancel();return}let t=this.on&&e.button===0?this.scene.gripAt(e.clientX,e.clientY):void 0;t&&(e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId),this.link.selectedIndex=t.link,this.drag={pointer:e.pointerId,x:e.clientX,y:e.clientY,grip:t,force:[0,0]},this.move(e))}move(e){if(this.drag||this.tellLink(e),e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{x:t,y:n,grip:s}=this.drag;this.drag.force=tm(e.clientX-t,n-e.clientY,this.scene.away(),this.chosen_N,this.bounds),this.showArrow(s,this.drag.force),this.tell(e,`${this.linkName(s.link)}: ${Fu(this.drag.force).toFixed(0)} N`)}tellLink(e){let t=this.on&&e.buttons===0?this.scene.gripAt(e.clientX,e.clientY):void 0;this.label.hidden=!t,t&&this.tell(e,this.linkName(t.link))}tell(e,t){Be(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}end(e){if(e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{grip:t,force:n}=this.drag;this.drag=void 0,this.label.hidden=!0,this.push(t,ku(n,this.heading()))}cancel(){this.drag&&(this.drag=void 0,this.label.hidden=!0,this.scene.hidePush())}pushBy([e,t]){let n=this.chosen_N;this.push(this.scene.gripOn(this.link.selectedIndex),[e*n,t*n])}push(e,t){if(!e)return;this.showArrow(e,ku(t,-this.heading()));let n=this.shown;setTimeout(()=>n===this.shown&&this.scene.hidePush(),Kx);let s=this.linkName(e.link);this.context.attempt(`Push of ${s}, ${Fu(t).toFixed(0)} N for ${.1} s`,()=>this.context.robot.order("/simulation/push",nm(s,t)))}showArrow(e,t){this.shown+=1,this.scene.showPush(e,t)}get chosen_N(){let{least:e,most:t,usual:n}=this.bounds;return Math.min(Math.max(Number(this.newtons.value)||n,e),t)}heading(){let{x:e,y:t,z:n,w:s}=this.scene.body.base.quaternion;return Zs([e,t,n,s])}linkName(e){return this.context.description.links[e]?.name??""}};/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Si={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ei={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Nm=0,Md=1,km=2;var Sd=1,Fm=2,Wi=3,rs=0,Fn=1,hi=2,ls=0,tr=1,Ed=2,Td=3,Ad=4,Um=5,Cs=100,Om=101,Bm=102,zm=103,Hm=104,Vm=200,Gm=201,Wm=202,Xm=203,Xl=204,$l=205,$m=206,qm=207,Ym=208,Zm=209,Km=210,Jm=211,jm=212,Qm=213,eg=214,vc=0,bc=1,wc=2,nr=3,Mc=4,Sc=5,Ec=6,Tc=7,Ac=0,tg=1,ng=2,cs=0,ig=1,sg=2,rg=3,og=4,ag=5,lg=6,cg=7;var Rd=300,mr=301,gr=302,Rc=303,Cc=304,Ca=306,ql=1e3,Rs=1001,Yl=1002,ci=1003,hg=1004;var Pa=1005;var wi=1006,Pc=1007;var ks=1008;var Ti=1009,Cd=1010,Pd=1011,po=1012,Ic=1013,Fs=1014,Xi=1015,mo=1016,Lc=1017,Dc=1018,go=1020,Id=35902,Ld=35899,Dd=1021,Nd=1022,ui=1023,no=1026,_o=1027,kd=1028,Nc=1029,Fd=1030,kc=1031;var Fc=1033,Ia=33776,La=33777,Da=33778,Na=33779,Uc=35840,Oc=35841,Bc=35842,zc=35843,Hc=36196,Vc=37492,Gc=37496,Wc=37808,Xc=37809,$c=37810,qc=37811,Yc=37812,Zc=37813,Kc=37814,Jc=37815,jc=37816,Qc=37817,eh=37818,th=37819,nh=37820,ih=37821,sh=36492,rh=36494,oh=36495,ah=36283,lh=36284,ch=36285,hh=36286;var Qo=2300,Zl=2301,Wl=2302,cd=2400,hd=2401,ud=2402;var ug=3200,dg=3201;var Ud=0,fg=1,hs="",Ht="srgb",ir="srgb-linear",ea="linear",Ct="srgb";var er=7680;var dd=519,pg=512,mg=513,gg=514,Od=515,_g=516,yg=517,xg=518,vg=519,fd=35044;var Bd="300 es",bi=2e3,ta=2001;var Oi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},En=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],im=1234567,Zo=Math.PI/180,io=180/Math.PI;function _r(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(En[i&255]+En[i>>8&255]+En[i>>16&255]+En[i>>24&255]+"-"+En[e&255]+En[e>>8&255]+"-"+En[e>>16&15|64]+En[e>>24&255]+"-"+En[t&63|128]+En[t>>8&255]+"-"+En[t>>16&255]+En[t>>24&255]+En[n&255]+En[n>>8&255]+En[n>>16&255]+En[n>>24&255]).toLowerCase()}function lt(i,e,t){return Math.max(e,Math.min(t,i))}function zd(i,e){return(i%e+e)%e}function jx(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Qx(i,e,t){return i!==e?(t-i)/(e-i):0}function Ko(i,e,t){return(1-t)*i+t*e}function ev(i,e,t,n){return Ko(i,e,1-Math.exp(-t*n))}function tv(i,e=1){return e-Math.abs(zd(i,e*2)-e)}function nv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function iv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function sv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function rv(i,e){return i+Math.random()*(e-i)}function ov(i){return i*(.5-Math.random())}function av(i){i!==void 0&&(im=i);let e=im+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function lv(i){return i*Zo}function cv(i){return i*io}function hv(i){return(i&i-1)===0&&i!==0}function uv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function dv(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function fv(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*h,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Qr(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function kn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}var ka={DEG2RAD:Zo,RAD2DEG:io,generateUUID:_r,clamp:lt,euclideanModulo:zd,mapLinear:jx,inverseLerp:Qx,lerp:Ko,damp:ev,pingpong:tv,smoothstep:nv,smootherstep:iv,randInt:sv,randFloat:rv,randFloatSpread:ov,seededRandom:av,degToRad:lv,radToDeg:cv,isPowerOfTwo:hv,ceilPowerOfTwo:uv,floorPowerOfTwo:dv,setQuaternionFromProperEuler:fv,normalize:kn,denormalize:Qr},be=class i{constructor(e=0,t=0){i.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(lt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(lt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},en=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(a===1){e[t+0]=d,e[t+1]=f,e[t+2]=g,e[t+3]=y;return}if(u!==y||l!==d||c!==f||h!==g){let m=1-a,p=l*d+c*f+h*g+u*y,b=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){let P=Math.sqrt(w),A=Math.atan2(P,p*b);m=Math.sin(m*A)/P,a=Math.sin(a*A)/P}let x=a*b;if(l=l*m+d*x,c=c*m+f*x,h=h*m+g*x,u=u*m+y*x,m===1-a){let P=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=P,c*=P,h*=P,u*=P}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*f-c*d,e[t+1]=l*g+h*d+c*u-a*f,e[t+2]=c*g+h*f+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"YXZ":this._x=d*h*u+c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"ZXY":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u-d*f*g;break;case"ZYX":this._x=d*h*u-c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u+d*f*g;break;case"YZX":this._x=d*h*u+c*f*g,this._y=c*f*u+d*h*g,this._z=c*h*g-d*f*u,this._w=c*h*u-d*f*g;break;case"XZY":this._x=d*h*u-c*f*g,this._y=c*f*u-d*h*g,this._z=c*h*g+d*f*u,this._w=c*h*u+d*f*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(lt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let n=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+n*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let f=1-t;return this._w=f*o+t*this._w,this._x=f*n+t*this._x,this._y=f*s+t*this._y,this._z=f*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-t)*h)/c,d=Math.sin(t*h)/c;return this._w=o*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=r*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},U=class i{constructor(e=0,t=0,n=0){i.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(sm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(sm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this.z=lt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this.z=lt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(lt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Uu.copy(this).projectOnVector(e),this.sub(Uu)}reflect(e){return this.sub(Uu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(lt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Uu=new U,sm=new en,ot=class i{constructor(e,t,n,s,r,o,a,l,c){i.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],g=n[8],y=s[0],m=s[3],p=s[6],b=s[1],w=s[4],x=s[7],P=s[2],A=s[5],D=s[8];return r[0]=o*y+a*b+l*P,r[3]=o*m+a*w+l*A,r[6]=o*p+a*x+l*D,r[1]=c*y+h*b+u*P,r[4]=c*m+h*w+u*A,r[7]=c*p+h*x+u*D,r[2]=d*y+f*b+g*P,r[5]=d*m+f*w+g*A,r[8]=d*p+f*x+g*D,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,g=t*u+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Ou.makeScale(e,t)),this}rotate(e){return this.premultiply(Ou.makeRotation(-e)),this}translate(e,t){return this.premultiply(Ou.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ou=new ot;function Hd(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function na(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function bg(){let i=na("canvas");return i.style.display="block",i}var rm={};function so(i){i in rm||(rm[i]=!0,console.warn(i))}function wg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var om=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),am=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function pv(){let i={enabled:!0,workingColorSpace:ir,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=ss(s.r),s.g=ss(s.g),s.b=ss(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=eo(s.r),s.g=eo(s.g),s.b=eo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===hs?ea:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return so("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return so("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[ir]:{primaries:e,whitePoint:n,transfer:ea,toXYZ:om,fromXYZ:am,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ht},outputColorSpaceConfig:{drawingBufferColorSpace:Ht}},[Ht]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:om,fromXYZ:am,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ht}}}),i}var _t=pv();function ss(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function eo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Hr,Kl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Hr===void 0&&(Hr=na("canvas")),Hr.width=e.width,Hr.height=e.height;let s=Hr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Hr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=na("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ss(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ss(t[n]/255)*255):t[n]=ss(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},mv=0,ro=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:mv++}),this.uuid=_r(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):t instanceof VideoFrame?e.set(t.displayHeight,t.displayWidth,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Bu(s[o].image)):r.push(Bu(s[o]))}else r=Bu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Bu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Kl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var gv=0,zu=new U,Yn=class i extends Oi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Rs,s=Rs,r=wi,o=ks,a=ui,l=Ti,c=i.DEFAULT_ANISOTROPY,h=hs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gv++}),this.uuid=_r(),this.name="",this.source=new ro(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new be(0,0),this.repeat=new be(1,1),this.center=new be(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(zu).x}get height(){return this.source.getSize(zu).y}get depth(){return this.source.getSize(zu).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Rd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ql:e.x=e.x-Math.floor(e.x);break;case Rs:e.x=e.x<0?0:1;break;case Yl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ql:e.y=e.y-Math.floor(e.y);break;case Rs:e.y=e.y<0?0:1;break;case Yl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Yn.DEFAULT_IMAGE=null;Yn.DEFAULT_MAPPING=Rd;Yn.DEFAULT_ANISOTROPY=1;var Jt=class i{constructor(e=0,t=0,n=0,s=1){i.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,x=(f+1)/2,P=(p+1)/2,A=(h+d)/4,D=(u+y)/4,F=(g+m)/4;return w>x&&w>P?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=A/n,r=D/n):x>P?x<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),n=A/s,r=F/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=D/r,s=F/r),this.set(n,s,r,t),this}let b=Math.sqrt((m-g)*(m-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(b)<.001&&(b=1),this.x=(m-g)/b,this.y=(u-y)/b,this.z=(d-h)/b,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this.z=lt(this.z,e.z,t.z),this.w=lt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this.z=lt(this.z,e,t),this.w=lt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(lt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Jl=class extends Oi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:wi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Jt(0,0,e,t),this.scissorTest=!1,this.viewport=new Jt(0,0,e,t);let s={width:e,height:t,depth:n.depth},r=new Yn(s);this.textures=[];let o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(e={}){let t={minFilter:wi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ro(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Bi=class extends Jl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},ia=class extends Yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Rs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jl=class extends Yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=ci,this.minFilter=ci,this.wrapR=Rs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var zi=class{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(yi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(yi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=yi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,yi):yi.fromBufferAttribute(r,o),yi.applyMatrix4(e.matrixWorld),this.expandByPoint(yi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),bl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),bl.copy(n.boundingBox)),bl.applyMatrix4(e.matrixWorld),this.union(bl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,yi),yi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Go),wl.subVectors(this.max,Go),Vr.subVectors(e.a,Go),Gr.subVectors(e.b,Go),Wr.subVectors(e.c,Go),bs.subVectors(Gr,Vr),ws.subVectors(Wr,Gr),Ks.subVectors(Vr,Wr);let t=[0,-bs.z,bs.y,0,-ws.z,ws.y,0,-Ks.z,Ks.y,bs.z,0,-bs.x,ws.z,0,-ws.x,Ks.z,0,-Ks.x,-bs.y,bs.x,0,-ws.y,ws.x,0,-Ks.y,Ks.x,0];return!Hu(t,Vr,Gr,Wr,wl)||(t=[1,0,0,0,1,0,0,0,1],!Hu(t,Vr,Gr,Wr,wl))?!1:(Ml.crossVectors(bs,ws),t=[Ml.x,Ml.y,Ml.z],Hu(t,Vr,Gr,Wr,wl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,yi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(yi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ji[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ji[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ji[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ji[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ji[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ji[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ji[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ji[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ji),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ji=[new U,new U,new U,new U,new U,new U,new U,new U],yi=new U,bl=new zi,Vr=new U,Gr=new U,Wr=new U,bs=new U,ws=new U,Ks=new U,Go=new U,wl=new U,Ml=new U,Js=new U;function Hu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Js.fromArray(i,r);let a=s.x*Math.abs(Js.x)+s.y*Math.abs(Js.y)+s.z*Math.abs(Js.z),l=e.dot(Js),c=t.dot(Js),h=n.dot(Js);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var _v=new zi,Wo=new U,Vu=new U,sr=class{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):_v.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Wo.subVectors(e,this.center);let t=Wo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Wo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Vu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Wo.copy(e.center).add(Vu)),this.expandByPoint(Wo.copy(e.center).sub(Vu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Qi=new U,Gu=new U,Sl=new U,Ms=new U,Wu=new U,El=new U,Xu=new U,Ps=class{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Qi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Qi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Qi.copy(this.origin).addScaledVector(this.direction,t),Qi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Gu.copy(e).add(t).multiplyScalar(.5),Sl.copy(t).sub(e).normalize(),Ms.copy(this.origin).sub(Gu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Sl),a=Ms.dot(this.direction),l=-Ms.dot(Sl),c=Ms.lengthSq(),h=Math.abs(1-o*o),u,d,f,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Gu).addScaledVector(Sl,d),f}intersectSphere(e,t){Qi.subVectors(e.center,this.origin);let n=Qi.dot(this.direction),s=Qi.dot(Qi)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Qi)!==null}intersectTriangle(e,t,n,s,r){Wu.subVectors(t,e),El.subVectors(n,e),Xu.crossVectors(Wu,El);let o=this.direction.dot(Xu),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ms.subVectors(this.origin,e);let l=a*this.direction.dot(El.crossVectors(Ms,El));if(l<0)return null;let c=a*this.direction.dot(Wu.cross(Ms));if(c<0||l+c>o)return null;let h=-a*Ms.dot(Xu);return h<0?null:this.at(h/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Et=class i{constructor(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,m){i.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,m)}set(e,t,n,s,r,o,a,l,c,h,u,d,f,g,y,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,n=e.elements,s=1/Xr.setFromMatrixColumn(e,0).length(),r=1/Xr.setFromMatrixColumn(e,1).length(),o=1/Xr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,f=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,f=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+f,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=f*u-g,t[2]=g*u-f,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(yv,e,xv)}lookAt(e,t,n){let s=this.elements;return $n.subVectors(e,t),$n.lengthSq()===0&&($n.z=1),$n.normalize(),Ss.crossVectors(n,$n),Ss.lengthSq()===0&&(Math.abs(n.z)===1?$n.x+=1e-4:$n.z+=1e-4,$n.normalize(),Ss.crossVectors(n,$n)),Ss.normalize(),Tl.crossVectors($n,Ss),s[0]=Ss.x,s[4]=Tl.x,s[8]=$n.x,s[1]=Ss.y,s[5]=Tl.y,s[9]=$n.y,s[2]=Ss.z,s[6]=Tl.z,s[10]=$n.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],g=n[2],y=n[6],m=n[10],p=n[14],b=n[3],w=n[7],x=n[11],P=n[15],A=s[0],D=s[4],F=s[8],T=s[12],S=s[1],R=s[5],B=s[9],V=s[13],X=s[2],$=s[6],q=s[10],Q=s[14],Z=s[3],ae=s[7],le=s[11],ye=s[15];return r[0]=o*A+a*S+l*X+c*Z,r[4]=o*D+a*R+l*$+c*ae,r[8]=o*F+a*B+l*q+c*le,r[12]=o*T+a*V+l*Q+c*ye,r[1]=h*A+u*S+d*X+f*Z,r[5]=h*D+u*R+d*$+f*ae,r[9]=h*F+u*B+d*q+f*le,r[13]=h*T+u*V+d*Q+f*ye,r[2]=g*A+y*S+m*X+p*Z,r[6]=g*D+y*R+m*$+p*ae,r[10]=g*F+y*B+m*q+p*le,r[14]=g*T+y*V+m*Q+p*ye,r[3]=b*A+w*S+x*X+P*Z,r[7]=b*D+w*R+x*$+P*ae,r[11]=b*F+w*B+x*q+P*le,r[15]=b*T+w*V+x*Q+P*ye,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],f=e[14],g=e[3],y=e[7],m=e[11],p=e[15];return g*(+r*l*u-s*c*u-r*a*d+n*c*d+s*a*f-n*l*f)+y*(+t*l*f-t*c*d+r*o*d-s*o*f+s*c*h-r*l*h)+m*(+t*c*u-t*a*f-r*o*u+n*o*f+r*a*h-n*c*h)+p*(-s*a*h-t*l*u+t*a*d+s*o*u-n*o*d+n*l*h)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],f=e[11],g=e[12],y=e[13],m=e[14],p=e[15],b=u*m*c-y*d*c+y*l*f-a*m*f-u*l*p+a*d*p,w=g*d*c-h*m*c-g*l*f+o*m*f+h*l*p-o*d*p,x=h*y*c-g*u*c+g*a*f-o*y*f-h*a*p+o*u*p,P=g*u*l-h*y*l-g*a*d+o*y*d+h*a*m-o*u*m,A=t*b+n*w+s*x+r*P;if(A===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/A;return e[0]=b*D,e[1]=(y*d*r-u*m*r-y*s*f+n*m*f+u*s*p-n*d*p)*D,e[2]=(a*m*r-y*l*r+y*s*c-n*m*c-a*s*p+n*l*p)*D,e[3]=(u*l*r-a*d*r-u*s*c+n*d*c+a*s*f-n*l*f)*D,e[4]=w*D,e[5]=(h*m*r-g*d*r+g*s*f-t*m*f-h*s*p+t*d*p)*D,e[6]=(g*l*r-o*m*r-g*s*c+t*m*c+o*s*p-t*l*p)*D,e[7]=(o*d*r-h*l*r+h*s*c-t*d*c-o*s*f+t*l*f)*D,e[8]=x*D,e[9]=(g*u*r-h*y*r-g*n*f+t*y*f+h*n*p-t*u*p)*D,e[10]=(o*y*r-g*a*r+g*n*c-t*y*c-o*n*p+t*a*p)*D,e[11]=(h*a*r-o*u*r-h*n*c+t*u*c+o*n*f-t*a*f)*D,e[12]=P*D,e[13]=(h*y*s-g*u*s+g*n*d-t*y*d-h*n*m+t*u*m)*D,e[14]=(g*a*s-o*y*s-g*n*l+t*y*l+o*n*m-t*a*m)*D,e[15]=(o*u*s-h*a*s+h*n*l-t*u*l-o*n*d+t*a*d)*D,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,g=r*u,y=o*h,m=o*u,p=a*u,b=l*c,w=l*h,x=l*u,P=n.x,A=n.y,D=n.z;return s[0]=(1-(y+p))*P,s[1]=(f+x)*P,s[2]=(g-w)*P,s[3]=0,s[4]=(f-x)*A,s[5]=(1-(d+p))*A,s[6]=(m+b)*A,s[7]=0,s[8]=(g+w)*D,s[9]=(m-b)*D,s[10]=(1-(d+y))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements,r=Xr.set(s[0],s[1],s[2]).length(),o=Xr.set(s[4],s[5],s[6]).length(),a=Xr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],xi.copy(this);let c=1/r,h=1/o,u=1/a;return xi.elements[0]*=c,xi.elements[1]*=c,xi.elements[2]*=c,xi.elements[4]*=h,xi.elements[5]*=h,xi.elements[6]*=h,xi.elements[8]*=u,xi.elements[9]*=u,xi.elements[10]*=u,t.setFromRotationMatrix(xi),n.x=r,n.y=o,n.z=a,this}makePerspective(e,t,n,s,r,o,a=bi,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===bi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===ta)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=bi,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===bi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===ta)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Xr=new U,xi=new Et,yv=new U(0,0,0),xv=new U(1,1,1),Ss=new U,Tl=new U,$n=new U,lm=new Et,cm=new en,Zn=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(lt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-lt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(lt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-lt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(lt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-lt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return lm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(lm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return cm.setFromEuler(this),this.setFromQuaternion(cm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Zn.DEFAULT_ORDER="XYZ";var oo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},vv=0,hm=new U,$r=new en,es=new Et,Al=new U,Xo=new U,bv=new U,wv=new en,um=new U(1,0,0),dm=new U(0,1,0),fm=new U(0,0,1),pm={type:"added"},Mv={type:"removed"},qr={type:"childadded",child:null},$u={type:"childremoved",child:null},wn=class i extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:vv++}),this.uuid=_r(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new U,t=new Zn,n=new en,s=new U(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Et},normalMatrix:{value:new ot}}),this.matrix=new Et,this.matrixWorld=new Et,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.multiply($r),this}rotateOnWorldAxis(e,t){return $r.setFromAxisAngle(e,t),this.quaternion.premultiply($r),this}rotateX(e){return this.rotateOnAxis(um,e)}rotateY(e){return this.rotateOnAxis(dm,e)}rotateZ(e){return this.rotateOnAxis(fm,e)}translateOnAxis(e,t){return hm.copy(e).applyQuaternion(this.quaternion),this.position.add(hm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(um,e)}translateY(e){return this.translateOnAxis(dm,e)}translateZ(e){return this.translateOnAxis(fm,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Al.copy(e):Al.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Xo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?es.lookAt(Xo,Al,this.up):es.lookAt(Al,Xo,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(s.matrixWorld),$r.setFromRotationMatrix(es),this.quaternion.premultiply($r.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(pm),qr.child=e,this.dispatchEvent(qr),qr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Mv),$u.child=e,this.dispatchEvent($u),$u.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),es.multiply(e.parent.matrixWorld)),e.applyMatrix4(es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(pm),qr.child=e,this.dispatchEvent(qr),qr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,e,bv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xo,wv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){let n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}};wn.DEFAULT_UP=new U(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var vi=new U,ts=new U,qu=new U,ns=new U,Yr=new U,Zr=new U,mm=new U,Yu=new U,Zu=new U,Ku=new U,Ju=new Jt,ju=new Jt,Qu=new Jt,As=class i{constructor(e=new U,t=new U,n=new U){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),vi.subVectors(e,t),s.cross(vi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){vi.subVectors(s,t),ts.subVectors(n,t),qu.subVectors(e,t);let o=vi.dot(vi),a=vi.dot(ts),l=vi.dot(qu),c=ts.dot(ts),h=ts.dot(qu),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ns)===null?!1:ns.x>=0&&ns.y>=0&&ns.x+ns.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ns)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ns.x),l.addScaledVector(o,ns.y),l.addScaledVector(a,ns.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Ju.setScalar(0),ju.setScalar(0),Qu.setScalar(0),Ju.fromBufferAttribute(e,t),ju.fromBufferAttribute(e,n),Qu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Ju,r.x),o.addScaledVector(ju,r.y),o.addScaledVector(Qu,r.z),o}static isFrontFacing(e,t,n,s){return vi.subVectors(n,t),ts.subVectors(e,t),vi.cross(ts).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return vi.subVectors(this.c,this.b),ts.subVectors(this.a,this.b),vi.cross(ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Yr.subVectors(s,n),Zr.subVectors(r,n),Yu.subVectors(e,n);let l=Yr.dot(Yu),c=Zr.dot(Yu);if(l<=0&&c<=0)return t.copy(n);Zu.subVectors(e,s);let h=Yr.dot(Zu),u=Zr.dot(Zu);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return o=l/(l-h),t.copy(n).addScaledVector(Yr,o);Ku.subVectors(e,r);let f=Yr.dot(Ku),g=Zr.dot(Ku);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Zr,a);let m=h*g-f*u;if(m<=0&&u-h>=0&&f-g>=0)return mm.subVectors(r,s),a=(u-h)/(u-h+(f-g)),t.copy(s).addScaledVector(mm,a);let p=1/(m+y+d);return o=y*p,a=d*p,t.copy(n).addScaledVector(Yr,o).addScaledVector(Zr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Mg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Es={h:0,s:0,l:0},Rl={h:0,s:0,l:0};function ed(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ze=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ht){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=n,_t.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=_t.workingColorSpace){if(e=zd(e,1),t=lt(t,0,1),n=lt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=ed(o,r,e+1/3),this.g=ed(o,r,e),this.b=ed(o,r,e-1/3)}return _t.colorSpaceToWorking(this,s),this}setStyle(e,t=Ht){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ht){let n=Mg[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ss(e.r),this.g=ss(e.g),this.b=ss(e.b),this}copyLinearToSRGB(e){return this.r=eo(e.r),this.g=eo(e.g),this.b=eo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ht){return _t.workingToColorSpace(Tn.copy(this),e),Math.round(lt(Tn.r*255,0,255))*65536+Math.round(lt(Tn.g*255,0,255))*256+Math.round(lt(Tn.b*255,0,255))}getHexString(e=Ht){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.workingToColorSpace(Tn.copy(this),t);let n=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=_t.workingColorSpace){return _t.workingToColorSpace(Tn.copy(this),t),e.r=Tn.r,e.g=Tn.g,e.b=Tn.b,e}getStyle(e=Ht){_t.workingToColorSpace(Tn.copy(this),e);let t=Tn.r,n=Tn.g,s=Tn.b;return e!==Ht?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Es),this.setHSL(Es.h+e,Es.s+t,Es.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Es),e.getHSL(Rl);let n=Ko(Es.h,Rl.h,t),s=Ko(Es.s,Rl.s,t),r=Ko(Es.l,Rl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tn=new Ze;Ze.NAMES=Mg;var Sv=0,os=class extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Sv++}),this.uuid=_r(),this.name="",this.type="Material",this.blending=tr,this.side=rs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xl,this.blendDst=$l,this.blendEquation=Cs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ze(0,0,0),this.blendAlpha=0,this.depthFunc=nr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=dd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=er,this.stencilZFail=er,this.stencilZPass=er,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==tr&&(n.blending=this.blending),this.side!==rs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Xl&&(n.blendSrc=this.blendSrc),this.blendDst!==$l&&(n.blendDst=this.blendDst),this.blendEquation!==Cs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==nr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==dd&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==er&&(n.stencilFail=this.stencilFail),this.stencilZFail!==er&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==er&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},An=class extends os{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ze(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zn,this.combine=Ac,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var nn=new U,Cl=new be,Ev=0,on=class{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ev++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=fd,this.updateRanges=[],this.gpuType=Xi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Cl.fromBufferAttribute(this,t),Cl.applyMatrix3(e),this.setXY(t,Cl.x,Cl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix3(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyMatrix4(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.applyNormalMatrix(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)nn.fromBufferAttribute(this,t),nn.transformDirection(e),this.setXYZ(t,nn.x,nn.y,nn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=Qr(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=kn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Qr(t,this.array)),t}setX(e,t){return this.normalized&&(t=kn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Qr(t,this.array)),t}setY(e,t){return this.normalized&&(t=kn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Qr(t,this.array)),t}setZ(e,t){return this.normalized&&(t=kn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Qr(t,this.array)),t}setW(e,t){return this.normalized&&(t=kn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=kn(t,this.array),n=kn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=kn(t,this.array),n=kn(n,this.array),s=kn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=kn(t,this.array),n=kn(n,this.array),s=kn(s,this.array),r=kn(r,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==fd&&(e.usage=this.usage),e}};var sa=class extends on{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ra=class extends on{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ut=class extends on{constructor(e,t,n){super(new Float32Array(e),t,n)}},Tv=0,ai=new Et,td=new wn,Kr=new U,qn=new zi,$o=new zi,yn=new U,Vt=class i extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Tv++}),this.uuid=_r(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Hd(e)?ra:sa)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ot().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return ai.makeRotationFromQuaternion(e),this.applyMatrix4(ai),this}rotateX(e){return ai.makeRotationX(e),this.applyMatrix4(ai),this}rotateY(e){return ai.makeRotationY(e),this.applyMatrix4(ai),this}rotateZ(e){return ai.makeRotationZ(e),this.applyMatrix4(ai),this}translate(e,t,n){return ai.makeTranslation(e,t,n),this.applyMatrix4(ai),this}scale(e,t,n){return ai.makeScale(e,t,n),this.applyMatrix4(ai),this}lookAt(e){return td.lookAt(e),td.updateMatrix(),this.applyMatrix4(td.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Kr).negate(),this.translate(Kr.x,Kr.y,Kr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ut(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];qn.setFromBufferAttribute(r),this.morphTargetsRelative?(yn.addVectors(this.boundingBox.min,qn.min),this.boundingBox.expandByPoint(yn),yn.addVectors(this.boundingBox.max,qn.max),this.boundingBox.expandByPoint(yn)):(this.boundingBox.expandByPoint(qn.min),this.boundingBox.expandByPoint(qn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new sr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){let n=this.boundingSphere.center;if(qn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];$o.setFromBufferAttribute(a),this.morphTargetsRelative?(yn.addVectors(qn.min,$o.min),qn.expandByPoint(yn),yn.addVectors(qn.max,$o.max),qn.expandByPoint(yn)):(qn.expandByPoint($o.min),qn.expandByPoint($o.max))}qn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)yn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(yn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)yn.fromBufferAttribute(a,c),l&&(Kr.fromBufferAttribute(e,c),yn.add(Kr)),s=Math.max(s,n.distanceToSquared(yn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new on(new Float32Array(4*n.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let F=0;F<n.count;F++)a[F]=new U,l[F]=new U;let c=new U,h=new U,u=new U,d=new be,f=new be,g=new be,y=new U,m=new U;function p(F,T,S){c.fromBufferAttribute(n,F),h.fromBufferAttribute(n,T),u.fromBufferAttribute(n,S),d.fromBufferAttribute(r,F),f.fromBufferAttribute(r,T),g.fromBufferAttribute(r,S),h.sub(c),u.sub(c),f.sub(d),g.sub(d);let R=1/(f.x*g.y-g.x*f.y);isFinite(R)&&(y.copy(h).multiplyScalar(g.y).addScaledVector(u,-f.y).multiplyScalar(R),m.copy(u).multiplyScalar(f.x).addScaledVector(h,-g.x).multiplyScalar(R),a[F].add(y),a[T].add(y),a[S].add(y),l[F].add(m),l[T].add(m),l[S].add(m))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let F=0,T=b.length;F<T;++F){let S=b[F],R=S.start,B=S.count;for(let V=R,X=R+B;V<X;V+=3)p(e.getX(V+0),e.getX(V+1),e.getX(V+2))}let w=new U,x=new U,P=new U,A=new U;function D(F){P.fromBufferAttribute(s,F),A.copy(P);let T=a[F];w.copy(T),w.sub(P.multiplyScalar(P.dot(T))).normalize(),x.crossVectors(A,T);let R=x.dot(l[F])<0?-1:1;o.setXYZW(F,w.x,w.y,w.z,R)}for(let F=0,T=b.length;F<T;++F){let S=b[F],R=S.start,B=S.count;for(let V=R,X=R+B;V<X;V+=3)D(e.getX(V+0)),D(e.getX(V+1)),D(e.getX(V+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new on(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,h=new U,u=new U;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)yn.fromBufferAttribute(e,t),yn.normalize(),e.setXYZ(t,yn.x,yn.y,yn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let p=0;p<h;p++)d[g++]=c[f++]}return new on(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},gm=new Et,js=new Ps,Pl=new sr,_m=new U,Il=new U,Ll=new U,Dl=new U,nd=new U,Nl=new U,ym=new U,kl=new U,mt=class extends wn{constructor(e=new Vt,t=new An){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Nl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(nd.fromBufferAttribute(u,e),o?Nl.addScaledVector(nd,h):Nl.addScaledVector(nd.sub(t),h))}t.add(Nl)}return t}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Pl.copy(n.boundingSphere),Pl.applyMatrix4(r),js.copy(e.ray).recast(e.near),!(Pl.containsPoint(js.origin)===!1&&(js.intersectSphere(Pl,_m)===null||js.origin.distanceToSquared(_m)>(e.far-e.near)**2))&&(gm.copy(r).invert(),js.copy(e.ray).applyMatrix4(gm),!(n.boundingBox!==null&&js.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,js)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],p=o[m.materialIndex],b=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let x=b,P=w;x<P;x+=3){let A=a.getX(x),D=a.getX(x+1),F=a.getX(x+2);s=Fl(this,p,e,n,c,h,u,A,D,F),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let b=a.getX(m),w=a.getX(m+1),x=a.getX(m+2);s=Fl(this,o,e,n,c,h,u,b,w,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],p=o[m.materialIndex],b=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let x=b,P=w;x<P;x+=3){let A=x,D=x+1,F=x+2;s=Fl(this,p,e,n,c,h,u,A,D,F),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let b=m,w=m+1,x=m+2;s=Fl(this,o,e,n,c,h,u,b,w,x),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Av(i,e,t,n,s,r,o,a){let l;if(e.side===Fn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===rs,a),l===null)return null;kl.copy(a),kl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(kl);return c<t.near||c>t.far?null:{distance:c,point:kl.clone(),object:i}}function Fl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Il),i.getVertexPosition(l,Ll),i.getVertexPosition(c,Dl);let h=Av(i,e,t,n,Il,Ll,Dl,ym);if(h){let u=new U;As.getBarycoord(ym,Il,Ll,Dl,u),s&&(h.uv=As.getInterpolatedAttribute(s,a,l,c,u,new be)),r&&(h.uv1=As.getInterpolatedAttribute(r,a,l,c,u,new be)),o&&(h.normal=As.getInterpolatedAttribute(o,a,l,c,u,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new U,materialIndex:0};As.getNormal(Il,Ll,Dl,d.normal),h.face=d,h.barycoord=u}return h}var Hi=class i extends Vt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ut(c,3)),this.setAttribute("normal",new ut(h,3)),this.setAttribute("uv",new ut(u,2));function g(y,m,p,b,w,x,P,A,D,F,T){let S=x/D,R=P/F,B=x/2,V=P/2,X=A/2,$=D+1,q=F+1,Q=0,Z=0,ae=new U;for(let le=0;le<q;le++){let ye=le*R-V;for(let we=0;we<$;we++){let _e=we*S-B;ae[y]=_e*b,ae[m]=ye*w,ae[p]=X,c.push(ae.x,ae.y,ae.z),ae[y]=0,ae[m]=0,ae[p]=A>0?1:-1,h.push(ae.x,ae.y,ae.z),u.push(we/D),u.push(1-le/F),Q+=1}}for(let le=0;le<F;le++)for(let ye=0;ye<D;ye++){let we=d+ye+$*le,_e=d+ye+$*(le+1),st=d+(ye+1)+$*(le+1),et=d+(ye+1)+$*le;l.push(we,_e,et),l.push(_e,st,et),Z+=6}a.addGroup(f,Z,T),f+=Z,d+=Q}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function yr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function Rn(i){let e={};for(let t=0;t<i.length;t++){let n=yr(i[t]);for(let s in n)e[s]=n[s]}return e}function Rv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Vd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}var Sg={clone:yr,merge:Rn},Cv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Pv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Mi=class extends os{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Cv,this.fragmentShader=Pv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=yr(e.uniforms),this.uniformsGroups=Rv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}},oa=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Et,this.projectionMatrix=new Et,this.projectionMatrixInverse=new Et,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Ts=new U,xm=new be,vm=new be,xn=class extends oa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=io*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Zo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return io*2*Math.atan(Math.tan(Zo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ts.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ts.x,Ts.y).multiplyScalar(-e/Ts.z),Ts.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ts.x,Ts.y).multiplyScalar(-e/Ts.z)}getViewSize(e,t){return this.getViewBounds(e,xm,vm),t.subVectors(vm,xm)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Zo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Jr=-90,jr=1,Ql=class extends wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new xn(Jr,jr,e,t);s.layers=this.layers,this.add(s);let r=new xn(Jr,jr,e,t);r.layers=this.layers,this.add(r);let o=new xn(Jr,jr,e,t);o.layers=this.layers,this.add(o);let a=new xn(Jr,jr,e,t);a.layers=this.layers,this.add(a);let l=new xn(Jr,jr,e,t);l.layers=this.layers,this.add(l);let c=new xn(Jr,jr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ta)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,r),e.setRenderTarget(n,1,s),e.render(t,o),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=y,e.setRenderTarget(n,5,s),e.render(t,h),e.setRenderTarget(u,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},aa=class extends Yn{constructor(e=[],t=mr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},ec=class extends Bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new aa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Hi(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:yr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Fn,blending:ls});r.uniforms.tEquirect.value=t;let o=new mt(s,r),a=t.minFilter;return t.minFilter===ks&&(t.minFilter=wi),new Ql(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Nt=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Iv={type:"move"},ao=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Nt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Nt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Nt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Iv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Nt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}};var la=class i{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new Ze(e),this.near=t,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},rr=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Zn,this.environmentIntensity=1,this.environmentRotation=new Zn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};var id=new U,Lv=new U,Dv=new ot,li=class{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=id.subVectors(n,t).cross(Lv.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let n=e.delta(id),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(n,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Dv.getNormalMatrix(e),s=this.coplanarPoint(id).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},Qs=new sr,Nv=new be(.5,.5),Ul=new U,lo=class{constructor(e=new li,t=new li,n=new li,s=new li,r=new li,o=new li){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=bi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],g=r[8],y=r[9],m=r[10],p=r[11],b=r[12],w=r[13],x=r[14],P=r[15];if(s[0].setComponents(c-o,f-h,p-g,P-b).normalize(),s[1].setComponents(c+o,f+h,p+g,P+b).normalize(),s[2].setComponents(c+a,f+u,p+y,P+w).normalize(),s[3].setComponents(c-a,f-u,p-y,P-w).normalize(),n)s[4].setComponents(l,d,m,x).normalize(),s[5].setComponents(c-l,f-d,p-m,P-x).normalize();else if(s[4].setComponents(c-l,f-d,p-m,P-x).normalize(),t===bi)s[5].setComponents(c+l,f+d,p+m,P+x).normalize();else if(t===ta)s[5].setComponents(l,d,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Qs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Qs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Qs)}intersectsSprite(e){Qs.center.set(0,0,0);let t=Nv.distanceTo(e.center);return Qs.radius=.7071067811865476+t,Qs.applyMatrix4(e.matrixWorld),this.intersectsSphere(Qs)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ul.x=s.normal.x>0?e.max.x:e.min.x,Ul.y=s.normal.y>0?e.max.y:e.min.y,Ul.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ul)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Vi=class extends os{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ze(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},tc=new U,nc=new U,bm=new Et,qo=new Ps,Ol=new sr,sd=new U,wm=new U,or=class extends wn{constructor(e=new Vt,t=new Vi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)tc.fromBufferAttribute(t,s-1),nc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=tc.distanceTo(nc);e.setAttribute("lineDistance",new ut(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ol.copy(n.boundingSphere),Ol.applyMatrix4(s),Ol.radius+=r,e.ray.intersectsSphere(Ol)===!1)return;bm.copy(s).invert(),qo.copy(e.ray).applyMatrix4(bm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=h.getX(y),b=h.getX(y+1),w=Bl(this,e,qo,l,p,b,y);w&&t.push(w)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(f),p=Bl(this,e,qo,l,y,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=Bl(this,e,qo,l,y,y+1,y);p&&t.push(p)}if(this.isLineLoop){let y=Bl(this,e,qo,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Bl(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(tc.fromBufferAttribute(a,s),nc.fromBufferAttribute(a,r),t.distanceSqToSegment(tc,nc,sd,wm)>n)return;sd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(sd);if(!(c<e.near||c>e.far))return{distance:c,point:wm.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Mm=new U,Sm=new U,co=class extends or{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Mm.fromBufferAttribute(t,s),Sm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Mm.distanceTo(Sm);e.setAttribute("lineDistance",new ut(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ca=class extends or{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}};var ha=class extends Yn{constructor(e,t,n=Fs,s,r,o,a=ci,l=ci,c,h=no,u=1){if(h!==no&&h!==_o)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ro(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}},ua=class extends Yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}};var da=class i extends Vt{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],l=[],c=new U,h=new be;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=t;u++,d+=3){let f=n+u/t*s;c.x=e*Math.cos(f),c.y=e*Math.sin(f),o.push(c.x,c.y,c.z),a.push(0,0,1),h.x=(o[d]/e+1)/2,h.y=(o[d+1]/e+1)/2,l.push(h.x,h.y)}for(let u=1;u<=t;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new ut(o,3)),this.setAttribute("normal",new ut(a,3)),this.setAttribute("uv",new ut(l,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},Gi=class i extends Vt{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],g=0,y=[],m=n/2,p=0;b(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new ut(u,3)),this.setAttribute("normal",new ut(d,3)),this.setAttribute("uv",new ut(f,2));function b(){let x=new U,P=new U,A=0,D=(t-e)/n;for(let F=0;F<=r;F++){let T=[],S=F/r,R=S*(t-e)+e;for(let B=0;B<=s;B++){let V=B/s,X=V*l+a,$=Math.sin(X),q=Math.cos(X);P.x=R*$,P.y=-S*n+m,P.z=R*q,u.push(P.x,P.y,P.z),x.set($,D,q).normalize(),d.push(x.x,x.y,x.z),f.push(V,1-S),T.push(g++)}y.push(T)}for(let F=0;F<s;F++)for(let T=0;T<r;T++){let S=y[T][F],R=y[T+1][F],B=y[T+1][F+1],V=y[T][F+1];(e>0||T!==0)&&(h.push(S,R,V),A+=3),(t>0||T!==r-1)&&(h.push(R,B,V),A+=3)}c.addGroup(p,A,0),p+=A}function w(x){let P=g,A=new be,D=new U,F=0,T=x===!0?e:t,S=x===!0?1:-1;for(let B=1;B<=s;B++)u.push(0,m*S,0),d.push(0,S,0),f.push(.5,.5),g++;let R=g;for(let B=0;B<=s;B++){let X=B/s*l+a,$=Math.cos(X),q=Math.sin(X);D.x=T*q,D.y=m*S,D.z=T*$,u.push(D.x,D.y,D.z),d.push(0,S,0),A.x=$*.5+.5,A.y=q*.5*S+.5,f.push(A.x,A.y),g++}for(let B=0;B<s;B++){let V=P+B,X=R+B;x===!0?h.push(X,X+1,V):h.push(X+1,X,V),F+=3}c.addGroup(p,F,x===!0?1:2),p+=F}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},fa=class i extends Gi{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Kn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let o=1;o<=e;o++)n=this.getPoint(o/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,o;t?o=t:o=e*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=t||(o.isVector2?new be:new U);return l.copy(a).sub(o).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new U,s=[],r=[],o=[],a=new U,l=new Et;for(let f=0;f<=e;f++){let g=f/e;s[f]=this.getTangentAt(g,new U)}r[0]=new U,o[0]=new U;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(lt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,g))}o[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(lt(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(a.crossVectors(r[0],r[e]))>0&&(f=-f);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],f*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this}},ho=class extends Kn{constructor(e=0,t=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(e,t=new be){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},ic=class extends ho{constructor(e,t,n,s,r,o){super(e,t,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Gd(){let i=0,e=0,t=0,n=0;function s(r,o,a,l){i=r,e=a,t=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+e*r+t*o+n*a}}}var zl=new U,rd=new Gd,od=new Gd,ad=new Gd,sc=class extends Kn{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new U){let n=t,s=this.points,r=s.length,o=(r-(this.closed?0:1))*e,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(zl.subVectors(s[0],s[1]).add(s[0]),c=zl);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(zl.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=zl),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(u),f),y=Math.pow(u.distanceToSquared(d),f),m=Math.pow(d.distanceToSquared(h),f);y<1e-4&&(y=1),g<1e-4&&(g=y),m<1e-4&&(m=y),rd.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,g,y,m),od.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,g,y,m),ad.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,g,y,m)}else this.curveType==="catmullrom"&&(rd.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),od.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),ad.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(rd.calc(l),od.calc(l),ad.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new U().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Em(i,e,t,n,s){let r=(n-e)*.5,o=(s-t)*.5,a=i*i,l=i*a;return(2*t-2*n+r+o)*l+(-3*t+3*n-2*r-o)*a+r*i+t}function kv(i,e){let t=1-i;return t*t*e}function Fv(i,e){return 2*(1-i)*i*e}function Uv(i,e){return i*i*e}function Jo(i,e,t,n){return kv(i,e)+Fv(i,t)+Uv(i,n)}function Ov(i,e){let t=1-i;return t*t*t*e}function Bv(i,e){let t=1-i;return 3*t*t*i*e}function zv(i,e){return 3*(1-i)*i*i*e}function Hv(i,e){return i*i*i*e}function jo(i,e,t,n,s){return Ov(i,e)+Bv(i,t)+zv(i,n)+Hv(i,s)}var pa=class extends Kn{constructor(e=new be,t=new be,n=new be,s=new be){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new be){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(jo(e,s.x,r.x,o.x,a.x),jo(e,s.y,r.y,o.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},rc=class extends Kn{constructor(e=new U,t=new U,n=new U,s=new U){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new U){let n=t,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(jo(e,s.x,r.x,o.x,a.x),jo(e,s.y,r.y,o.y,a.y),jo(e,s.z,r.z,o.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ma=class extends Kn{constructor(e=new be,t=new be){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new be){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new be){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},oc=class extends Kn{constructor(e=new U,t=new U){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new U){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new U){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ga=class extends Kn{constructor(e=new be,t=new be,n=new be){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new be){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Jo(e,s.x,r.x,o.x),Jo(e,s.y,r.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},ac=class extends Kn{constructor(e=new U,t=new U,n=new U){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new U){let n=t,s=this.v0,r=this.v1,o=this.v2;return n.set(Jo(e,s.x,r.x,o.x),Jo(e,s.y,r.y,o.y),Jo(e,s.z,r.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},_a=class extends Kn{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new be){let n=t,s=this.points,r=(s.length-1)*e,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(Em(a,l.x,c.x,h.x,u.x),Em(a,l.y,c.y,h.y,u.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new be().fromArray(s))}return this}},Tm=Object.freeze({__proto__:null,ArcCurve:ic,CatmullRomCurve3:sc,CubicBezierCurve:pa,CubicBezierCurve3:rc,EllipseCurve:ho,LineCurve:ma,LineCurve3:oc,QuadraticBezierCurve:ga,QuadraticBezierCurve3:ac,SplineCurve:_a}),lc=class extends Kn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(e){this.curves.push(e)}closePath(){let e=this.curves[0].getPoint(0),t=this.curves[this.curves.length-1].getPoint(1);if(!e.equals(t)){let n=e.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Tm[n](t,e))}return this}getPoint(e,t){let n=e*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,t)}r++}return null}getLength(){let e=this.getCurveLengths();return e[e.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let e=[],t=0;for(let n=0,s=this.curves.length;n<s;n++)t+=this.curves[n].getLength(),e.push(t);return this.cacheLengths=e,e}getSpacedPoints(e=40){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return this.autoClose&&t.push(t[0]),t}getPoints(e=12){let t=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?e*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?e*o.points.length:e,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(t.push(h),n=h)}}return this.autoClose&&t.length>1&&!t[t.length-1].equals(t[0])&&t.push(t[0]),t}copy(e){super.copy(e),this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(s.clone())}return this.autoClose=e.autoClose,this}toJSON(){let e=super.toJSON();e.autoClose=this.autoClose,e.curves=[];for(let t=0,n=this.curves.length;t<n;t++){let s=this.curves[t];e.curves.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.autoClose=e.autoClose,this.curves=[];for(let t=0,n=e.curves.length;t<n;t++){let s=e.curves[t];this.curves.push(new Tm[s.type]().fromJSON(s))}return this}},ya=class extends lc{constructor(e){super(),this.type="Path",this.currentPoint=new be,e&&this.setFromPoints(e)}setFromPoints(e){this.moveTo(e[0].x,e[0].y);for(let t=1,n=e.length;t<n;t++)this.lineTo(e[t].x,e[t].y);return this}moveTo(e,t){return this.currentPoint.set(e,t),this}lineTo(e,t){let n=new ma(this.currentPoint.clone(),new be(e,t));return this.curves.push(n),this.currentPoint.set(e,t),this}quadraticCurveTo(e,t,n,s){let r=new ga(this.currentPoint.clone(),new be(e,t),new be(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(e,t,n,s,r,o){let a=new pa(this.currentPoint.clone(),new be(e,t),new be(n,s),new be(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(e){let t=[this.currentPoint.clone()].concat(e),n=new _a(t);return this.curves.push(n),this.currentPoint.copy(e[e.length-1]),this}arc(e,t,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(e+a,t+l,n,s,r,o),this}absarc(e,t,n,s,r,o){return this.absellipse(e,t,n,n,s,r,o),this}ellipse(e,t,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(e+c,t+h,n,s,r,o,a,l),this}absellipse(e,t,n,s,r,o,a,l){let c=new ho(e,t,n,s,r,o,a,l);if(this.curves.length>0){let u=c.getPoint(0);u.equals(this.currentPoint)||this.lineTo(u.x,u.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(e){return super.copy(e),this.currentPoint.copy(e.currentPoint),this}toJSON(){let e=super.toJSON();return e.currentPoint=this.currentPoint.toArray(),e}fromJSON(e){return super.fromJSON(e),this.currentPoint.fromArray(e.currentPoint),this}},as=class extends ya{constructor(e){super(e),this.uuid=_r(),this.type="Shape",this.holes=[]}getPointsHoles(e){let t=[];for(let n=0,s=this.holes.length;n<s;n++)t[n]=this.holes[n].getPoints(e);return t}extractPoints(e){return{shape:this.getPoints(e),holes:this.getPointsHoles(e)}}copy(e){super.copy(e),this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.uuid=this.uuid,e.holes=[];for(let t=0,n=this.holes.length;t<n;t++){let s=this.holes[t];e.holes.push(s.toJSON())}return e}fromJSON(e){super.fromJSON(e),this.uuid=e.uuid,this.holes=[];for(let t=0,n=e.holes.length;t<n;t++){let s=e.holes[t];this.holes.push(new ya().fromJSON(s))}return this}};function Vv(i,e,t=2){let n=e&&e.length,s=n?e[0]*t:i.length,r=Eg(i,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=qv(i,e,r,t)),i.length>80*t){a=1/0,l=1/0;let h=-1/0,u=-1/0;for(let d=t;d<s;d+=t){let f=i[d],g=i[d+1];f<a&&(a=f),g<l&&(l=g),f>h&&(h=f),g>u&&(u=g)}c=Math.max(h-a,u-l),c=c!==0?32767/c:0}return xa(r,o,t,a,l,c,0),o}function Eg(i,e,t,n,s){let r;if(s===sb(i,e,t,n)>0)for(let o=e;o<t;o+=n)r=Am(o/n|0,i[o],i[o+1],r);else for(let o=t-n;o>=e;o-=n)r=Am(o/n|0,i[o],i[o+1],r);return r&&uo(r,r.next)&&(ba(r),r=r.next),r}function ar(i,e){if(!i)return i;e||(e=i);let t=i,n;do if(n=!1,!t.steiner&&(uo(t,t.next)||Kt(t.prev,t,t.next)===0)){if(ba(t),t=e=t.prev,t===t.next)break;n=!0}else t=t.next;while(n||t!==e);return e}function xa(i,e,t,n,s,r,o){if(!i)return;!o&&r&&jv(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?Wv(i,n,s,r):Gv(i)){e.push(l.i,i.i,c.i),ba(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=Xv(ar(i),e),xa(i,e,t,n,s,r,2)):o===2&&$v(i,e,t,n,s,r):xa(ar(i),e,t,n,s,r,1);break}}}function Gv(i){let e=i.prev,t=i,n=i.next;if(Kt(e,t,n)>=0)return!1;let s=e.x,r=t.x,o=n.x,a=e.y,l=t.y,c=n.y,h=Math.min(s,r,o),u=Math.min(a,l,c),d=Math.max(s,r,o),f=Math.max(a,l,c),g=n.next;for(;g!==e;){if(g.x>=h&&g.x<=d&&g.y>=u&&g.y<=f&&Yo(s,a,r,l,o,c,g.x,g.y)&&Kt(g.prev,g,g.next)>=0)return!1;g=g.next}return!0}function Wv(i,e,t,n){let s=i.prev,r=i,o=i.next;if(Kt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,u=r.y,d=o.y,f=Math.min(a,l,c),g=Math.min(h,u,d),y=Math.max(a,l,c),m=Math.max(h,u,d),p=pd(f,g,e,t,n),b=pd(y,m,e,t,n),w=i.prevZ,x=i.nextZ;for(;w&&w.z>=p&&x&&x.z<=b;){if(w.x>=f&&w.x<=y&&w.y>=g&&w.y<=m&&w!==s&&w!==o&&Yo(a,h,l,u,c,d,w.x,w.y)&&Kt(w.prev,w,w.next)>=0||(w=w.prevZ,x.x>=f&&x.x<=y&&x.y>=g&&x.y<=m&&x!==s&&x!==o&&Yo(a,h,l,u,c,d,x.x,x.y)&&Kt(x.prev,x,x.next)>=0))return!1;x=x.nextZ}for(;w&&w.z>=p;){if(w.x>=f&&w.x<=y&&w.y>=g&&w.y<=m&&w!==s&&w!==o&&Yo(a,h,l,u,c,d,w.x,w.y)&&Kt(w.prev,w,w.next)>=0)return!1;w=w.prevZ}for(;x&&x.z<=b;){if(x.x>=f&&x.x<=y&&x.y>=g&&x.y<=m&&x!==s&&x!==o&&Yo(a,h,l,u,c,d,x.x,x.y)&&Kt(x.prev,x,x.next)>=0)return!1;x=x.nextZ}return!0}function Xv(i,e){let t=i;do{let n=t.prev,s=t.next.next;!uo(n,s)&&Ag(n,t,t.next,s)&&va(n,s)&&va(s,n)&&(e.push(n.i,t.i,s.i),ba(t),ba(t.next),t=i=s),t=t.next}while(t!==i);return ar(t)}function $v(i,e,t,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&tb(o,a)){let l=Rg(o,a);o=ar(o,o.next),l=ar(l,l.next),xa(o,e,t,n,s,r,0),xa(l,e,t,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function qv(i,e,t,n){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*n,l=r<o-1?e[r+1]*n:i.length,c=Eg(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(eb(c))}s.sort(Yv);for(let r=0;r<s.length;r++)t=Zv(s[r],t);return t}function Yv(i,e){let t=i.x-e.x;if(t===0&&(t=i.y-e.y,t===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=n-s}return t}function Zv(i,e){let t=Kv(i,e);if(!t)return e;let n=Rg(t,i);return ar(n,n.next),ar(t,t.next)}function Kv(i,e){let t=e,n=i.x,s=i.y,r=-1/0,o;if(uo(i,t))return t;do{if(uo(i,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let u=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(u<=n&&u>r&&(r=u,o=t.x<t.next.x?t:t.next,u===n))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;t=o;do{if(n>=t.x&&t.x>=l&&n!==t.x&&Tg(s<c?n:r,s,l,c,s<c?r:n,s,t.x,t.y)){let u=Math.abs(s-t.y)/(n-t.x);va(t,i)&&(u<h||u===h&&(t.x>o.x||t.x===o.x&&Jv(o,t)))&&(o=t,h=u)}t=t.next}while(t!==a);return o}function Jv(i,e){return Kt(i.prev,i,e.prev)<0&&Kt(e.next,i,i.next)<0}function jv(i,e,t,n){let s=i;do s.z===0&&(s.z=pd(s.x,s.y,e,t,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,Qv(s)}function Qv(i){let e,t=1;do{let n=i,s;i=null;let r=null;for(e=0;n;){e++;let o=n,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,t*=2}while(e>1);return i}function pd(i,e,t,n,s){return i=(i-t)*s|0,e=(e-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,i|e<<1}function eb(i){let e=i,t=i;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==i);return t}function Tg(i,e,t,n,s,r,o,a){return(s-o)*(e-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(n-a)}function Yo(i,e,t,n,s,r,o,a){return!(i===o&&e===a)&&Tg(i,e,t,n,s,r,o,a)}function tb(i,e){return i.next.i!==e.i&&i.prev.i!==e.i&&!nb(i,e)&&(va(i,e)&&va(e,i)&&ib(i,e)&&(Kt(i.prev,i,e.prev)||Kt(i,e.prev,e))||uo(i,e)&&Kt(i.prev,i,i.next)>0&&Kt(e.prev,e,e.next)>0)}function Kt(i,e,t){return(e.y-i.y)*(t.x-e.x)-(e.x-i.x)*(t.y-e.y)}function uo(i,e){return i.x===e.x&&i.y===e.y}function Ag(i,e,t,n){let s=Vl(Kt(i,e,t)),r=Vl(Kt(i,e,n)),o=Vl(Kt(t,n,i)),a=Vl(Kt(t,n,e));return!!(s!==r&&o!==a||s===0&&Hl(i,t,e)||r===0&&Hl(i,n,e)||o===0&&Hl(t,i,n)||a===0&&Hl(t,e,n))}function Hl(i,e,t){return e.x<=Math.max(i.x,t.x)&&e.x>=Math.min(i.x,t.x)&&e.y<=Math.max(i.y,t.y)&&e.y>=Math.min(i.y,t.y)}function Vl(i){return i>0?1:i<0?-1:0}function nb(i,e){let t=i;do{if(t.i!==i.i&&t.next.i!==i.i&&t.i!==e.i&&t.next.i!==e.i&&Ag(t,t.next,i,e))return!0;t=t.next}while(t!==i);return!1}function va(i,e){return Kt(i.prev,i,i.next)<0?Kt(i,e,i.next)>=0&&Kt(i,i.prev,e)>=0:Kt(i,e,i.prev)<0||Kt(i,i.next,e)<0}function ib(i,e){let t=i,n=!1,s=(i.x+e.x)/2,r=(i.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(n=!n),t=t.next;while(t!==i);return n}function Rg(i,e){let t=md(i.i,i.x,i.y),n=md(e.i,e.x,e.y),s=i.next,r=e.prev;return i.next=e,e.prev=i,t.next=s,s.prev=t,n.next=t,t.prev=n,r.next=n,n.prev=r,n}function Am(i,e,t,n){let s=md(i,e,t);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function ba(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function md(i,e,t){return{i,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function sb(i,e,t,n){let s=0;for(let r=e,o=t-n;r<t;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var gd=class{static triangulate(e,t,n=2){return Vv(e,t,n)}},to=class i{static area(e){let t=e.length,n=0;for(let s=t-1,r=0;r<t;s=r++)n+=e[s].x*e[r].y-e[r].x*e[s].y;return n*.5}static isClockWise(e){return i.area(e)<0}static triangulateShape(e,t){let n=[],s=[],r=[];Rm(e),Cm(n,e);let o=e.length;t.forEach(Rm);for(let l=0;l<t.length;l++)s.push(o),o+=t[l].length,Cm(n,t[l]);let a=gd.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function Rm(i){let e=i.length;e>2&&i[e-1].equals(i[0])&&i.pop()}function Cm(i,e){for(let t=0;t<e.length;t++)i.push(e[t].x),i.push(e[t].y)}var lr=class i extends Vt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let b=p*d-o;for(let w=0;w<c;w++){let x=w*u-r;g.push(x,-b,0),y.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let b=0;b<a;b++){let w=b+c*p,x=b+c*(p+1),P=b+1+c*(p+1),A=b+1+c*p;f.push(w,x,A),f.push(x,P,A)}this.setIndex(f),this.setAttribute("position",new ut(g,3)),this.setAttribute("normal",new ut(y,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},wa=class i extends Vt{constructor(e=.5,t=1,n=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:s,thetaStart:r,thetaLength:o},n=Math.max(3,n),s=Math.max(1,s);let a=[],l=[],c=[],h=[],u=e,d=(t-e)/s,f=new U,g=new be;for(let y=0;y<=s;y++){for(let m=0;m<=n;m++){let p=r+m/n*o;f.x=u*Math.cos(p),f.y=u*Math.sin(p),l.push(f.x,f.y,f.z),c.push(0,0,1),g.x=(f.x/t+1)/2,g.y=(f.y/t+1)/2,h.push(g.x,g.y)}u+=d}for(let y=0;y<s;y++){let m=y*(n+1);for(let p=0;p<n;p++){let b=p+m,w=b,x=b+n+1,P=b+n+2,A=b+1;a.push(w,x,A),a.push(x,P,A)}}this.setIndex(a),this.setAttribute("position",new ut(l,3)),this.setAttribute("normal",new ut(c,3)),this.setAttribute("uv",new ut(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}},Is=class i extends Vt{constructor(e=new as([new be(0,.5),new be(-.5,-.5),new be(.5,-.5)]),t=12){super(),this.type="ShapeGeometry",this.parameters={shapes:e,curveSegments:t};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(e)===!1)c(e);else for(let h=0;h<e.length;h++)c(e[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new ut(s,3)),this.setAttribute("normal",new ut(r,3)),this.setAttribute("uv",new ut(o,2));function c(h){let u=s.length/3,d=h.extractPoints(t),f=d.shape,g=d.holes;to.isClockWise(f)===!1&&(f=f.reverse());for(let m=0,p=g.length;m<p;m++){let b=g[m];to.isClockWise(b)===!0&&(g[m]=b.reverse())}let y=to.triangulateShape(f,g);for(let m=0,p=g.length;m<p;m++){let b=g[m];f=f.concat(b)}for(let m=0,p=f.length;m<p;m++){let b=f[m];s.push(b.x,b.y,0),r.push(0,0,1),o.push(b.x,b.y)}for(let m=0,p=y.length;m<p;m++){let b=y[m],w=b[0]+u,x=b[1]+u,P=b[2]+u;n.push(w,x,P),l+=3}}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON(),t=this.parameters.shapes;return rb(t,e)}static fromJSON(e,t){let n=[];for(let s=0,r=e.shapes.length;s<r;s++){let o=t[e.shapes[s]];n.push(o)}return new i(n,e.curveSegments)}};function rb(i,e){if(e.shapes=[],Array.isArray(i))for(let t=0,n=i.length;t<n;t++){let s=i[t];e.shapes.push(s.uuid)}else e.shapes.push(i.uuid);return e}var Ls=class i extends Vt{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new U,d=new U,f=[],g=[],y=[],m=[];for(let p=0;p<=n;p++){let b=[],w=p/n,x=0;p===0&&o===0?x=.5/t:p===n&&l===Math.PI&&(x=-.5/t);for(let P=0;P<=t;P++){let A=P/t;u.x=-e*Math.cos(s+A*r)*Math.sin(o+w*a),u.y=e*Math.cos(o+w*a),u.z=e*Math.sin(s+A*r)*Math.sin(o+w*a),g.push(u.x,u.y,u.z),d.copy(u).normalize(),y.push(d.x,d.y,d.z),m.push(A+x,1-w),b.push(c++)}h.push(b)}for(let p=0;p<n;p++)for(let b=0;b<t;b++){let w=h[p][b+1],x=h[p][b],P=h[p+1][b],A=h[p+1][b+1];(p!==0||o>0)&&f.push(w,x,A),(p!==n-1||l<Math.PI)&&f.push(x,P,A)}this.setIndex(f),this.setAttribute("position",new ut(g,3)),this.setAttribute("normal",new ut(y,3)),this.setAttribute("uv",new ut(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var cr=class extends os{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ze(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ze(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ud,this.normalScale=new be(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zn,this.combine=Ac,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},cc=class extends os{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ug,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},hc=class extends os{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Gl(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function ob(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}var hr=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},uc=class extends hr{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:cd,endingEnd:cd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case hd:r=e,a=2*t-n;break;case ud:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case hd:o=e,l=2*n-t;break;case ud:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,m=y*g,p=-d*m+2*d*y-d*g,b=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*g+1,w=(-1-f)*m+(1.5+f)*y+.5*g,x=f*m-f*y;for(let P=0;P!==a;++P)r[P]=p*o[h+P]+b*o[c+P]+w*o[l+P]+x*o[u+P];return r}},dc=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},fc=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Jn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Gl(t,this.TimeBufferType),this.values=Gl(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Gl(e.times,Array),values:Gl(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s)}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new fc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new uc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case Qo:t=this.InterpolantFactoryMethodDiscrete;break;case Zl:t=this.InterpolantFactoryMethodLinear;break;case Wl:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return console.warn("THREE.KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Qo;case this.InterpolantFactoryMethodLinear:return Zl;case this.InterpolantFactoryMethodSmooth:return Wl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&ob(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Wl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[u+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};Jn.prototype.ValueTypeName="";Jn.prototype.TimeBufferType=Float32Array;Jn.prototype.ValueBufferType=Float32Array;Jn.prototype.DefaultInterpolation=Zl;var Ds=class extends Jn{constructor(e,t,n){super(e,t,n)}};Ds.prototype.ValueTypeName="bool";Ds.prototype.ValueBufferType=Array;Ds.prototype.DefaultInterpolation=Qo;Ds.prototype.InterpolantFactoryMethodLinear=void 0;Ds.prototype.InterpolantFactoryMethodSmooth=void 0;var pc=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};pc.prototype.ValueTypeName="color";var mc=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};mc.prototype.ValueTypeName="number";var gc=class extends hr{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)en.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ma=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new gc(this.times,this.values,this.getValueSize(),e)}};Ma.prototype.ValueTypeName="quaternion";Ma.prototype.InterpolantFactoryMethodSmooth=void 0;var Ns=class extends Jn{constructor(e,t,n){super(e,t,n)}};Ns.prototype.ValueTypeName="string";Ns.prototype.ValueBufferType=Array;Ns.prototype.DefaultInterpolation=Qo;Ns.prototype.InterpolantFactoryMethodLinear=void 0;Ns.prototype.InterpolantFactoryMethodSmooth=void 0;var _c=class extends Jn{constructor(e,t,n,s){super(e,t,n,s)}};_c.prototype.ValueTypeName="vector";var _d={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(this.files[i]=e)},get:function(i){if(this.enabled!==!1)return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}},yc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this.abortController=new AbortController,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],g=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},Cg=new yc,ur=class{constructor(e){this.manager=e!==void 0?e:Cg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}abort(){return this}};ur.DEFAULT_MATERIAL_NAME="__DEFAULT";var is={},yd=class extends Error{constructor(e,t){super(e),this.response=t}},Sa=class extends ur{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=_d.get(`file:${e}`);if(r!==void 0)return this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0),r;if(is[e]!==void 0){is[e].push({onLoad:t,onProgress:n,onError:s});return}is[e]=[],is[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&console.warn("THREE.FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let h=is[e],u=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,y=0,m=new ReadableStream({start(p){b();function b(){u.read().then(({done:w,value:x})=>{if(w)p.close();else{y+=x.byteLength;let P=new ProgressEvent("progress",{lengthComputable:g,loaded:y,total:f});for(let A=0,D=h.length;A<D;A++){let F=h[A];F.onProgress&&F.onProgress(P)}p.enqueue(x),b()}},w=>{p.error(w)})}}});return new Response(m)}else throw new yd(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(h=>new DOMParser().parseFromString(h,a));case"json":return c.json();default:if(a==="")return c.text();{let u=/charset="?([^;"\s]*)"?/i.exec(a),d=u&&u[1]?u[1].toLowerCase():void 0,f=new TextDecoder(d);return c.arrayBuffer().then(g=>f.decode(g))}}}).then(c=>{_d.add(`file:${e}`,c);let h=is[e];delete is[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onLoad&&f.onLoad(c)}}).catch(c=>{let h=is[e];if(h===void 0)throw this.manager.itemError(e),c;delete is[e];for(let u=0,d=h.length;u<d;u++){let f=h[u];f.onError&&f.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Ea=class extends wn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ze(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}},dr=class extends Ea{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ze(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}},ld=new Et,Pm=new U,Im=new U,xd=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new be(512,512),this.mapType=Ti,this.map=null,this.mapPass=null,this.matrix=new Et,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new lo,this._frameExtents=new be(1,1),this._viewportCount=1,this._viewports=[new Jt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera,n=this.matrix;Pm.setFromMatrixPosition(e.matrixWorld),t.position.copy(Pm),Im.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Im),t.updateMatrixWorld(),ld.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(ld,t.coordinateSystem,t.reversedDepth),t.reversedDepth?n.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(ld)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}};var Ta=class extends oa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},vd=class extends xd{constructor(){super(new Ta(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fr=class extends Ea{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.shadow=new vd}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}};var xc=class extends xn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var Wd="\\[\\]\\.:\\/",ab=new RegExp("["+Wd+"]","g"),Xd="[^"+Wd+"]",lb="[^"+Wd.replace("\\.","")+"]",cb=/((?:WC+[\/:])*)/.source.replace("WC",Xd),hb=/(WCOD+)?/.source.replace("WCOD",lb),ub=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Xd),db=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Xd),fb=new RegExp("^"+cb+hb+ub+db+"$"),pb=["material","materials","bones","map"],bd=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ab,"")}static parseTrackName(e){let t=fb.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);pb.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=bd;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var TC=new Float32Array(1);var Lm=new Et,Aa=class{constructor(e,t,n=0,s=1/0){this.ray=new Ps(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new oo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Lm.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Lm),this}intersectObject(e,t=!0,n=[]){return wd(e,this,n,t),n.sort(Dm),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)wd(e[s],this,n,t);return n.sort(Dm),n}};function Dm(i,e){return i.distance-e.distance}function wd(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)wd(r[o],e,t,!0)}}var fo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=lt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(lt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var pr=class extends co{constructor(e=10,t=10,n=4473924,s=8947848){n=new Ze(n),s=new Ze(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let d=0,f=0,g=-a;d<=t;d++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let y=d===r?n:s;y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3,y.toArray(c,f),f+=3}let h=new Vt;h.setAttribute("position",new ut(l,3)),h.setAttribute("color",new ut(c,3));let u=new Vi({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){this.geometry.dispose(),this.material.dispose()}};var Ra=class extends Oi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function $d(i,e,t,n){let s=mb(n);switch(t){case Dd:return i*e;case kd:return i*e/s.components*s.byteLength;case Nc:return i*e/s.components*s.byteLength;case Fd:return i*e*2/s.components*s.byteLength;case kc:return i*e*2/s.components*s.byteLength;case Nd:return i*e*3/s.components*s.byteLength;case ui:return i*e*4/s.components*s.byteLength;case Fc:return i*e*4/s.components*s.byteLength;case Ia:case La:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Da:case Na:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Oc:case zc:return Math.max(i,16)*Math.max(e,8)/4;case Uc:case Bc:return Math.max(i,8)*Math.max(e,8)/2;case Hc:case Vc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Gc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Xc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case $c:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case qc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Yc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Jc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case jc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case eh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case th:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case nh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ih:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case sh:case rh:case oh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case ah:case lh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ch:case hh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mb(i){switch(i){case Ti:case Cd:return{byteLength:1,components:1};case po:case Pd:case mo:return{byteLength:2,components:1};case Lc:case Dc:return{byteLength:2,components:4};case Fs:case Ic:case Xi:return{byteLength:4,components:1};case Id:case Ld:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Qg(){let i=null,e=!1,t=null,n=null;function s(r,o){t(r,o),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function _b(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<u.length;f++){let g=u[d],y=u[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let f=0,g=u.length;f<g;f++){let y=u[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var yb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,xb=`#ifdef USE_ALPHAHASH
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
#endif`,vb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,bb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,wb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Mb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Sb=`#ifdef USE_AOMAP
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
#endif`,Eb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Tb=`#ifdef USE_BATCHING
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
#endif`,Ab=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Rb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Cb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Pb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ib=`#ifdef USE_IRIDESCENCE
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
#endif`,Lb=`#ifdef USE_BUMPMAP
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
#endif`,Db=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Nb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Fb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ub=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Ob=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Bb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,zb=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Hb=`#define PI 3.141592653589793
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
} // validated`,Vb=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Gb=`vec3 transformedNormal = objectNormal;
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
#endif`,Wb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Xb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$b=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,qb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Yb="gl_FragColor = linearToOutputTexel( gl_FragColor );",Zb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Kb=`#ifdef USE_ENVMAP
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
#endif`,Jb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,jb=`#ifdef USE_ENVMAP
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
#endif`,Qb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,ew=`#ifdef USE_ENVMAP
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
#endif`,tw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,iw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rw=`#ifdef USE_GRADIENTMAP
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
}`,ow=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,aw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cw=`uniform bool receiveShadow;
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
#endif`,hw=`#ifdef USE_ENVMAP
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
#endif`,uw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,dw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,fw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mw=`PhysicalMaterial material;
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
#endif`,gw=`struct PhysicalMaterial {
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
}`,_w=`
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
#endif`,yw=`#if defined( RE_IndirectDiffuse )
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
#endif`,xw=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,bw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ww=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Sw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ew=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Tw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Aw=`#if defined( USE_POINTS_UV )
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
#endif`,Rw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Cw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Pw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Iw=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Lw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Dw=`#ifdef USE_MORPHTARGETS
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
#endif`,Nw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Fw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Uw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ow=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Bw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,zw=`#ifdef USE_NORMALMAP
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
#endif`,Hw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Vw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Gw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Ww=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Xw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$w=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,qw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Yw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Zw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Kw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Jw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Qw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,tM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,nM=`float getShadowMask() {
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
}`,iM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,sM=`#ifdef USE_SKINNING
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
#endif`,rM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,oM=`#ifdef USE_SKINNING
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
#endif`,aM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,lM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,hM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,uM=`#ifdef USE_TRANSMISSION
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
#endif`,dM=`#ifdef USE_TRANSMISSION
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
#endif`,fM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_M=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,yM=`uniform sampler2D t2D;
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
}`,xM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,bM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MM=`#include <common>
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
}`,SM=`#if DEPTH_PACKING == 3200
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
}`,EM=`#define DISTANCE
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
}`,TM=`#define DISTANCE
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
}`,AM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,RM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,CM=`uniform float scale;
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
}`,PM=`uniform vec3 diffuse;
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
}`,IM=`#include <common>
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
}`,LM=`uniform vec3 diffuse;
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
}`,DM=`#define LAMBERT
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
}`,NM=`#define LAMBERT
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
}`,kM=`#define MATCAP
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
}`,FM=`#define MATCAP
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
}`,UM=`#define NORMAL
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
}`,OM=`#define NORMAL
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
}`,BM=`#define PHONG
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
}`,zM=`#define PHONG
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
}`,HM=`#define STANDARD
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
}`,VM=`#define STANDARD
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
}`,GM=`#define TOON
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
}`,WM=`#define TOON
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
}`,XM=`uniform float size;
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
}`,$M=`uniform vec3 diffuse;
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
}`,qM=`#include <common>
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
}`,YM=`uniform vec3 color;
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
}`,ZM=`uniform float rotation;
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
}`,KM=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:yb,alphahash_pars_fragment:xb,alphamap_fragment:vb,alphamap_pars_fragment:bb,alphatest_fragment:wb,alphatest_pars_fragment:Mb,aomap_fragment:Sb,aomap_pars_fragment:Eb,batching_pars_vertex:Tb,batching_vertex:Ab,begin_vertex:Rb,beginnormal_vertex:Cb,bsdfs:Pb,iridescence_fragment:Ib,bumpmap_pars_fragment:Lb,clipping_planes_fragment:Db,clipping_planes_pars_fragment:Nb,clipping_planes_pars_vertex:kb,clipping_planes_vertex:Fb,color_fragment:Ub,color_pars_fragment:Ob,color_pars_vertex:Bb,color_vertex:zb,common:Hb,cube_uv_reflection_fragment:Vb,defaultnormal_vertex:Gb,displacementmap_pars_vertex:Wb,displacementmap_vertex:Xb,emissivemap_fragment:$b,emissivemap_pars_fragment:qb,colorspace_fragment:Yb,colorspace_pars_fragment:Zb,envmap_fragment:Kb,envmap_common_pars_fragment:Jb,envmap_pars_fragment:jb,envmap_pars_vertex:Qb,envmap_physical_pars_fragment:hw,envmap_vertex:ew,fog_vertex:tw,fog_pars_vertex:nw,fog_fragment:iw,fog_pars_fragment:sw,gradientmap_pars_fragment:rw,lightmap_pars_fragment:ow,lights_lambert_fragment:aw,lights_lambert_pars_fragment:lw,lights_pars_begin:cw,lights_toon_fragment:uw,lights_toon_pars_fragment:dw,lights_phong_fragment:fw,lights_phong_pars_fragment:pw,lights_physical_fragment:mw,lights_physical_pars_fragment:gw,lights_fragment_begin:_w,lights_fragment_maps:yw,lights_fragment_end:xw,logdepthbuf_fragment:vw,logdepthbuf_pars_fragment:bw,logdepthbuf_pars_vertex:ww,logdepthbuf_vertex:Mw,map_fragment:Sw,map_pars_fragment:Ew,map_particle_fragment:Tw,map_particle_pars_fragment:Aw,metalnessmap_fragment:Rw,metalnessmap_pars_fragment:Cw,morphinstance_vertex:Pw,morphcolor_vertex:Iw,morphnormal_vertex:Lw,morphtarget_pars_vertex:Dw,morphtarget_vertex:Nw,normal_fragment_begin:kw,normal_fragment_maps:Fw,normal_pars_fragment:Uw,normal_pars_vertex:Ow,normal_vertex:Bw,normalmap_pars_fragment:zw,clearcoat_normal_fragment_begin:Hw,clearcoat_normal_fragment_maps:Vw,clearcoat_pars_fragment:Gw,iridescence_pars_fragment:Ww,opaque_fragment:Xw,packing:$w,premultiplied_alpha_fragment:qw,project_vertex:Yw,dithering_fragment:Zw,dithering_pars_fragment:Kw,roughnessmap_fragment:Jw,roughnessmap_pars_fragment:jw,shadowmap_pars_fragment:Qw,shadowmap_pars_vertex:eM,shadowmap_vertex:tM,shadowmask_pars_fragment:nM,skinbase_vertex:iM,skinning_pars_vertex:sM,skinning_vertex:rM,skinnormal_vertex:oM,specularmap_fragment:aM,specularmap_pars_fragment:lM,tonemapping_fragment:cM,tonemapping_pars_fragment:hM,transmission_fragment:uM,transmission_pars_fragment:dM,uv_pars_fragment:fM,uv_pars_vertex:pM,uv_vertex:mM,worldpos_vertex:gM,background_vert:_M,background_frag:yM,backgroundCube_vert:xM,backgroundCube_frag:vM,cube_vert:bM,cube_frag:wM,depth_vert:MM,depth_frag:SM,distanceRGBA_vert:EM,distanceRGBA_frag:TM,equirect_vert:AM,equirect_frag:RM,linedashed_vert:CM,linedashed_frag:PM,meshbasic_vert:IM,meshbasic_frag:LM,meshlambert_vert:DM,meshlambert_frag:NM,meshmatcap_vert:kM,meshmatcap_frag:FM,meshnormal_vert:UM,meshnormal_frag:OM,meshphong_vert:BM,meshphong_frag:zM,meshphysical_vert:HM,meshphysical_frag:VM,meshtoon_vert:GM,meshtoon_frag:WM,points_vert:XM,points_frag:$M,shadow_vert:qM,shadow_frag:YM,sprite_vert:ZM,sprite_frag:KM},Se={common:{diffuse:{value:new Ze(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new be(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ze(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Ze(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new Ze(16777215)},opacity:{value:1},center:{value:new be(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},$i={basic:{uniforms:Rn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:Rn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new Ze(0)}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:Rn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new Ze(0)},specular:{value:new Ze(1118481)},shininess:{value:30}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:Rn([Se.common,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.roughnessmap,Se.metalnessmap,Se.fog,Se.lights,{emissive:{value:new Ze(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:Rn([Se.common,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.gradientmap,Se.fog,Se.lights,{emissive:{value:new Ze(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:Rn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:Rn([Se.points,Se.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:Rn([Se.common,Se.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:Rn([Se.common,Se.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:Rn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:Rn([Se.sprite,Se.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distanceRGBA:{uniforms:Rn([Se.common,Se.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distanceRGBA_vert,fragmentShader:ct.distanceRGBA_frag},shadow:{uniforms:Rn([Se.lights,Se.fog,{color:{value:new Ze(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};$i.physical={uniforms:Rn([$i.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new be(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new Ze(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new be},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new Ze(0)},specularColor:{value:new Ze(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new be},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var uh={r:0,b:0,g:0},xr=new Zn,JM=new Et;function jM(i,e,t,n,s,r,o){let a=new Ze(0),l=r===!0?0:1,c,h,u=null,d=0,f=null;function g(w){let x=w.isScene===!0?w.background:null;return x&&x.isTexture&&(x=(w.backgroundBlurriness>0?t:e).get(x)),x}function y(w){let x=!1,P=g(w);P===null?p(a,l):P&&P.isColor&&(p(P,1),x=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?n.buffers.color.setClear(0,0,0,1,o):A==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||x)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(w,x){let P=g(x);P&&(P.isCubeTexture||P.mapping===Ca)?(h===void 0&&(h=new mt(new Hi(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:yr($i.backgroundCube.uniforms),vertexShader:$i.backgroundCube.vertexShader,fragmentShader:$i.backgroundCube.fragmentShader,side:Fn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(A,D,F){this.matrixWorld.copyPosition(F.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),xr.copy(x.backgroundRotation),xr.x*=-1,xr.y*=-1,xr.z*=-1,P.isCubeTexture&&P.isRenderTargetTexture===!1&&(xr.y*=-1,xr.z*=-1),h.material.uniforms.envMap.value=P,h.material.uniforms.flipEnvMap.value=P.isCubeTexture&&P.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=x.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(JM.makeRotationFromEuler(xr)),h.material.toneMapped=_t.getTransfer(P.colorSpace)!==Ct,(u!==P||d!==P.version||f!==i.toneMapping)&&(h.material.needsUpdate=!0,u=P,d=P.version,f=i.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):P&&P.isTexture&&(c===void 0&&(c=new mt(new lr(2,2),new Mi({name:"BackgroundMaterial",uniforms:yr($i.background.uniforms),vertexShader:$i.background.vertexShader,fragmentShader:$i.background.fragmentShader,side:rs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=P,c.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,c.material.toneMapped=_t.getTransfer(P.colorSpace)!==Ct,P.matrixAutoUpdate===!0&&P.updateMatrix(),c.material.uniforms.uvTransform.value.copy(P.matrix),(u!==P||d!==P.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=P,d=P.version,f=i.toneMapping),c.layers.enableAll(),w.unshift(c,c.geometry,c.material,0,0,null))}function p(w,x){w.getRGB(uh,Vd(i)),n.buffers.color.setClear(uh.r,uh.g,uh.b,x,o)}function b(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(w,x=1){a.set(w),l=x,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(w){l=w,p(a,l)},render:y,addToRenderList:m,dispose:b}}function QM(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(S,R,B,V,X){let $=!1,q=u(V,B,R);r!==q&&(r=q,c(r.object)),$=f(S,V,B,X),$&&g(S,V,B,X),X!==null&&e.update(X,i.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,x(S,R,B,V),X!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(X).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function h(S){return i.deleteVertexArray(S)}function u(S,R,B){let V=B.wireframe===!0,X=n[S.id];X===void 0&&(X={},n[S.id]=X);let $=X[R.id];$===void 0&&($={},X[R.id]=$);let q=$[V];return q===void 0&&(q=d(l()),$[V]=q),q}function d(S){let R=[],B=[],V=[];for(let X=0;X<t;X++)R[X]=0,B[X]=0,V[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:R,enabledAttributes:B,attributeDivisors:V,object:S,attributes:{},index:null}}function f(S,R,B,V){let X=r.attributes,$=R.attributes,q=0,Q=B.getAttributes();for(let Z in Q)if(Q[Z].location>=0){let le=X[Z],ye=$[Z];if(ye===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(ye=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(ye=S.instanceColor)),le===void 0||le.attribute!==ye||ye&&le.data!==ye.data)return!0;q++}return r.attributesNum!==q||r.index!==V}function g(S,R,B,V){let X={},$=R.attributes,q=0,Q=B.getAttributes();for(let Z in Q)if(Q[Z].location>=0){let le=$[Z];le===void 0&&(Z==="instanceMatrix"&&S.instanceMatrix&&(le=S.instanceMatrix),Z==="instanceColor"&&S.instanceColor&&(le=S.instanceColor));let ye={};ye.attribute=le,le&&le.data&&(ye.data=le.data),X[Z]=ye,q++}r.attributes=X,r.attributesNum=q,r.index=V}function y(){let S=r.newAttributes;for(let R=0,B=S.length;R<B;R++)S[R]=0}function m(S){p(S,0)}function p(S,R){let B=r.newAttributes,V=r.enabledAttributes,X=r.attributeDivisors;B[S]=1,V[S]===0&&(i.enableVertexAttribArray(S),V[S]=1),X[S]!==R&&(i.vertexAttribDivisor(S,R),X[S]=R)}function b(){let S=r.newAttributes,R=r.enabledAttributes;for(let B=0,V=R.length;B<V;B++)R[B]!==S[B]&&(i.disableVertexAttribArray(B),R[B]=0)}function w(S,R,B,V,X,$,q){q===!0?i.vertexAttribIPointer(S,R,B,X,$):i.vertexAttribPointer(S,R,B,V,X,$)}function x(S,R,B,V){y();let X=V.attributes,$=B.getAttributes(),q=R.defaultAttributeValues;for(let Q in $){let Z=$[Q];if(Z.location>=0){let ae=X[Q];if(ae===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ae=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ae=S.instanceColor)),ae!==void 0){let le=ae.normalized,ye=ae.itemSize,we=e.get(ae);if(we===void 0)continue;let _e=we.buffer,st=we.type,et=we.bytesPerElement,ee=st===i.INT||st===i.UNSIGNED_INT||ae.gpuType===Ic;if(ae.isInterleavedBufferAttribute){let ne=ae.data,Ee=ne.stride,He=ae.offset;if(ne.isInstancedInterleavedBuffer){for(let xe=0;xe<Z.locationSize;xe++)p(Z.location+xe,ne.meshPerAttribute);S.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ne.meshPerAttribute*ne.count)}else for(let xe=0;xe<Z.locationSize;xe++)m(Z.location+xe);i.bindBuffer(i.ARRAY_BUFFER,_e);for(let xe=0;xe<Z.locationSize;xe++)w(Z.location+xe,ye/Z.locationSize,st,le,Ee*et,(He+ye/Z.locationSize*xe)*et,ee)}else{if(ae.isInstancedBufferAttribute){for(let ne=0;ne<Z.locationSize;ne++)p(Z.location+ne,ae.meshPerAttribute);S.isInstancedMesh!==!0&&V._maxInstanceCount===void 0&&(V._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let ne=0;ne<Z.locationSize;ne++)m(Z.location+ne);i.bindBuffer(i.ARRAY_BUFFER,_e);for(let ne=0;ne<Z.locationSize;ne++)w(Z.location+ne,ye/Z.locationSize,st,le,ye*et,ye/Z.locationSize*ne*et,ee)}}else if(q!==void 0){let le=q[Q];if(le!==void 0)switch(le.length){case 2:i.vertexAttrib2fv(Z.location,le);break;case 3:i.vertexAttrib3fv(Z.location,le);break;case 4:i.vertexAttrib4fv(Z.location,le);break;default:i.vertexAttrib1fv(Z.location,le)}}}}b()}function P(){F();for(let S in n){let R=n[S];for(let B in R){let V=R[B];for(let X in V)h(V[X].object),delete V[X];delete R[B]}delete n[S]}}function A(S){if(n[S.id]===void 0)return;let R=n[S.id];for(let B in R){let V=R[B];for(let X in V)h(V[X].object),delete V[X];delete R[B]}delete n[S.id]}function D(S){for(let R in n){let B=n[R];if(B[S.id]===void 0)continue;let V=B[S.id];for(let X in V)h(V[X].object),delete V[X];delete B[S.id]}}function F(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:T,dispose:P,releaseStatesOfGeometry:A,releaseStatesOfProgram:D,initAttributes:y,enableAttribute:m,disableUnusedAttributes:b}}function eS(i,e,t){let n;function s(c){n=c}function r(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function o(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),t.update(h,n,u))}function a(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let f=0;for(let g=0;g<u;g++)f+=h[g];t.update(f,n,1)}function l(c,h,u,d){if(u===0)return;let f=e.get("WEBGL_multi_draw");if(f===null)for(let g=0;g<c.length;g++)o(c[g],h[g],d[g]);else{f.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let g=0;for(let y=0;y<u;y++)g+=h[y]*d[y];t.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function tS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let D=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==ui&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let F=D===mo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==Ti&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==Xi&&!F)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),b=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=g>0,A=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:b,maxVaryings:w,maxFragmentUniforms:x,vertexTextures:P,maxSamples:A}}function nS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new li,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,f){let g=u.clippingPlanes,y=u.clipIntersection,m=u.clipShadows,p=i.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let b=r?0:n,w=b*4,x=p.clippingState||null;l.value=x,x=h(g,d,w,f);for(let P=0;P!==w;++P)x[P]=t[P];p.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,f,g){let y=u!==null?u.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=f+y*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,x=f;w!==y;++w,x+=4)o.copy(u[w]).applyMatrix4(b,a),o.normal.toArray(m,x),m[x+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}function iS(i){let e=new WeakMap;function t(o,a){return a===Rc?o.mapping=mr:a===Cc&&(o.mapping=gr),o}function n(o){if(o&&o.isTexture){let a=o.mapping;if(a===Rc||a===Cc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new ec(l.height);return c.fromEquirectangularTexture(i,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:n,dispose:r}}var xo=4,Pg=[.125,.215,.35,.446,.526,.582],wr=20,qd=new Ta,Ig=new Ze,Yd=null,Zd=0,Kd=0,Jd=!1,br=(1+Math.sqrt(5))/2,yo=1/br,Lg=[new U(-br,yo,0),new U(br,yo,0),new U(-yo,0,br),new U(yo,0,br),new U(0,br,-yo),new U(0,br,yo),new U(-1,1,-1),new U(1,1,-1),new U(-1,1,1),new U(1,1,1)],sS=new U,ph=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=sS}=r;Yd=this._renderer.getRenderTarget(),Zd=this._renderer.getActiveCubeFace(),Kd=this._renderer.getActiveMipmapLevel(),Jd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,n,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=kg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ng(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Yd,Zd,Kd),this._renderer.xr.enabled=Jd,e.scissorTest=!1,dh(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===mr||e.mapping===gr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Yd=this._renderer.getRenderTarget(),Zd=this._renderer.getActiveCubeFace(),Kd=this._renderer.getActiveMipmapLevel(),Jd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:wi,minFilter:wi,generateMipmaps:!1,type:mo,format:ui,colorSpace:ir,depthBuffer:!1},s=Dg(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Dg(e,t,n);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=rS(r)),this._blurMaterial=oS(r,e,t)}return s}_compileMaterial(e){let t=new mt(this._lodPlanes[0],e);this._renderer.compile(t,qd)}_sceneToCubeUV(e,t,n,s,r){let l=new xn(90,1,t,n),c=[1,-1,1,1,1,1],h=[1,1,1,-1,-1,-1],u=this._renderer,d=u.autoClear,f=u.toneMapping;u.getClearColor(Ig),u.toneMapping=cs,u.autoClear=!1,u.state.buffers.depth.getReversed()&&(u.setRenderTarget(s),u.clearDepth(),u.setRenderTarget(null));let y=new An({name:"PMREM.Background",side:Fn,depthWrite:!1,depthTest:!1}),m=new mt(new Hi,y),p=!1,b=e.background;b?b.isColor&&(y.color.copy(b),e.background=null,p=!0):(y.color.copy(Ig),p=!0);for(let w=0;w<6;w++){let x=w%3;x===0?(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+h[w],r.y,r.z)):x===1?(l.up.set(0,0,c[w]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+h[w],r.z)):(l.up.set(0,c[w],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+h[w]));let P=this._cubeSize;dh(s,x*P,w>2?P:0,P,P),u.setRenderTarget(s),p&&u.render(m,l),u.render(e,l)}m.geometry.dispose(),m.material.dispose(),u.toneMapping=f,u.autoClear=d,e.background=b}_textureToCubeUV(e,t){let n=this._renderer,s=e.mapping===mr||e.mapping===gr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=kg()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Ng());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new mt(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;dh(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(o,qd)}_applyPMREM(e){let t=this._renderer,n=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Lg[(s-r-1)%Lg.length];this._blur(e,r-1,r,o,a)}t.autoClear=n}_blur(e,t,n,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,n,s,"latitudinal",r),this._halfBlur(o,e,n,n,s,"longitudinal",r)}_halfBlur(e,t,n,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let h=3,u=new mt(this._lodPlanes[s],c),d=c.uniforms,f=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*f):2*Math.PI/(2*wr-1),y=r/g,m=isFinite(r)?1+Math.floor(h*y):wr;m>wr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${wr}`);let p=[],b=0;for(let D=0;D<wr;++D){let F=D/y,T=Math.exp(-F*F/2);p.push(T),D===0?b+=T:D<m&&(b+=2*T)}for(let D=0;D<p.length;D++)p[D]=p[D]/b;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=p,d.latitudinal.value=o==="latitudinal",a&&(d.poleAxis.value=a);let{_lodMax:w}=this;d.dTheta.value=g,d.mipInt.value=w-n;let x=this._sizeLods[s],P=3*x*(s>w-xo?s-w+xo:0),A=4*(this._cubeSize-x);dh(t,P,A,3*x,2*x),l.setRenderTarget(t),l.render(u,qd)}};function rS(i){let e=[],t=[],n=[],s=i,r=i-xo+1+Pg.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>i-xo?l=Pg[o-i+xo-1]:o===0&&(l=0),n.push(l);let c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],f=6,g=6,y=3,m=2,p=1,b=new Float32Array(y*g*f),w=new Float32Array(m*g*f),x=new Float32Array(p*g*f);for(let A=0;A<f;A++){let D=A%3*2/3-1,F=A>2?0:-1,T=[D,F,0,D+2/3,F,0,D+2/3,F+1,0,D,F,0,D+2/3,F+1,0,D,F+1,0];b.set(T,y*g*A),w.set(d,m*g*A);let S=[A,A,A,A,A,A];x.set(S,p*g*A)}let P=new Vt;P.setAttribute("position",new on(b,y)),P.setAttribute("uv",new on(w,m)),P.setAttribute("faceIndex",new on(x,p)),e.push(P),s>xo&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function Dg(i,e,t){let n=new Bi(i,e,t);return n.texture.mapping=Ca,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function dh(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function oS(i,e,t){let n=new Float32Array(wr),s=new U(0,1,0);return new Mi({name:"SphericalGaussianBlur",defines:{n:wr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:lf(),fragmentShader:`

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
		`,blending:ls,depthTest:!1,depthWrite:!1})}function Ng(){return new Mi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:lf(),fragmentShader:`

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
		`,blending:ls,depthTest:!1,depthWrite:!1})}function kg(){return new Mi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:lf(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ls,depthTest:!1,depthWrite:!1})}function lf(){return`

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
	`}function aS(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){let l=a.mapping,c=l===Rc||l===Cc,h=l===mr||l===gr;if(c||h){let u=e.get(a),d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new ph(i)),u=c?t.fromEquirectangular(a,u):t.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),u.texture;if(u!==void 0)return u.texture;{let f=a.image;return c&&f&&f.height>0||h&&f&&s(f)?(t===null&&(t=new ph(i)),u=c?t.fromEquirectangular(a):t.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),a.addEventListener("dispose",r),u.texture):null}}}return a}function s(a){let l=0,c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:o}}function lS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&so("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function cS(i,e,t,n){let s={},r=new WeakMap;function o(u){let d=u.target;d.index!==null&&e.remove(d.index);for(let g in d.attributes)e.remove(d.attributes[g]);d.removeEventListener("dispose",o),delete s[d.id];let f=r.get(d);f&&(e.remove(f),r.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",o),s[d.id]=!0,t.memory.geometries++),d}function l(u){let d=u.attributes;for(let f in d)e.update(d[f],i.ARRAY_BUFFER)}function c(u){let d=[],f=u.index,g=u.attributes.position,y=0;if(f!==null){let b=f.array;y=f.version;for(let w=0,x=b.length;w<x;w+=3){let P=b[w+0],A=b[w+1],D=b[w+2];d.push(P,A,A,D,D,P)}}else if(g!==void 0){let b=g.array;y=g.version;for(let w=0,x=b.length/3-1;w<x;w+=3){let P=w+0,A=w+1,D=w+2;d.push(P,A,A,D,D,P)}}else return;let m=new(Hd(d)?ra:sa)(d,1);m.version=y;let p=r.get(u);p&&e.remove(p),r.set(u,m)}function h(u){let d=r.get(u);if(d){let f=u.index;f!==null&&d.version<f.version&&c(u)}else c(u);return r.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function hS(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,f){i.drawElements(n,f,r,d*o),t.update(f,n,1)}function c(d,f,g){g!==0&&(i.drawElementsInstanced(n,f,r,d*o,g),t.update(f,n,g))}function h(d,f,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,d,0,g);let m=0;for(let p=0;p<g;p++)m+=f[p];t.update(m,n,1)}function u(d,f,g,y){if(g===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<d.length;p++)c(d[p]/o,f[p],y[p]);else{m.multiDrawElementsInstancedWEBGL(n,f,0,r,d,0,y,0,g);let p=0;for(let b=0;b<g;b++)p+=f[b]*y[b];t.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function uS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function dS(i,e,t){let n=new WeakMap,s=new Jt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let T=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],w=0;f===!0&&(w=1),g===!0&&(w=2),y===!0&&(w=3);let x=a.attributes.position.count*w,P=1;x>e.maxTextureSize&&(P=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let A=new Float32Array(x*P*4*u),D=new ia(A,x,P,u);D.type=Xi,D.needsUpdate=!0;let F=w*4;for(let S=0;S<u;S++){let R=m[S],B=p[S],V=b[S],X=x*P*4*S;for(let $=0;$<R.count;$++){let q=$*F;f===!0&&(s.fromBufferAttribute(R,$),A[X+q+0]=s.x,A[X+q+1]=s.y,A[X+q+2]=s.z,A[X+q+3]=0),g===!0&&(s.fromBufferAttribute(B,$),A[X+q+4]=s.x,A[X+q+5]=s.y,A[X+q+6]=s.z,A[X+q+7]=0),y===!0&&(s.fromBufferAttribute(V,$),A[X+q+8]=s.x,A[X+q+9]=s.y,A[X+q+10]=s.z,A[X+q+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:D,size:new be(x,P)},n.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function fS(i,e,t,n){let s=new WeakMap;function r(l){let c=n.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var e0=new Yn,Fg=new ha(1,1),t0=new ia,n0=new jl,i0=new aa,Ug=[],Og=[],Bg=new Float32Array(16),zg=new Float32Array(9),Hg=new Float32Array(4);function wo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Ug[s];if(r===void 0&&(r=new Float32Array(s),Ug[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function an(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function ln(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function mh(i,e){let t=Og[e];t===void 0&&(t=new Int32Array(e),Og[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function pS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function mS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2fv(this.addr,e),ln(t,e)}}function gS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(an(t,e))return;i.uniform3fv(this.addr,e),ln(t,e)}}function _S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4fv(this.addr,e),ln(t,e)}}function yS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;Hg.set(n),i.uniformMatrix2fv(this.addr,!1,Hg),ln(t,n)}}function xS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;zg.set(n),i.uniformMatrix3fv(this.addr,!1,zg),ln(t,n)}}function vS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(an(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),ln(t,e)}else{if(an(t,n))return;Bg.set(n),i.uniformMatrix4fv(this.addr,!1,Bg),ln(t,n)}}function bS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function wS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2iv(this.addr,e),ln(t,e)}}function MS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3iv(this.addr,e),ln(t,e)}}function SS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4iv(this.addr,e),ln(t,e)}}function ES(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function TS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(an(t,e))return;i.uniform2uiv(this.addr,e),ln(t,e)}}function AS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(an(t,e))return;i.uniform3uiv(this.addr,e),ln(t,e)}}function RS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(an(t,e))return;i.uniform4uiv(this.addr,e),ln(t,e)}}function CS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Fg.compareFunction=Od,r=Fg):r=e0,t.setTexture2D(e||r,s)}function PS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||n0,s)}function IS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||i0,s)}function LS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||t0,s)}function DS(i){switch(i){case 5126:return pS;case 35664:return mS;case 35665:return gS;case 35666:return _S;case 35674:return yS;case 35675:return xS;case 35676:return vS;case 5124:case 35670:return bS;case 35667:case 35671:return wS;case 35668:case 35672:return MS;case 35669:case 35673:return SS;case 5125:return ES;case 36294:return TS;case 36295:return AS;case 36296:return RS;case 35678:case 36198:case 36298:case 36306:case 35682:return CS;case 35679:case 36299:case 36307:return PS;case 35680:case 36300:case 36308:case 36293:return IS;case 36289:case 36303:case 36311:case 36292:return LS}}function NS(i,e){i.uniform1fv(this.addr,e)}function kS(i,e){let t=wo(e,this.size,2);i.uniform2fv(this.addr,t)}function FS(i,e){let t=wo(e,this.size,3);i.uniform3fv(this.addr,t)}function US(i,e){let t=wo(e,this.size,4);i.uniform4fv(this.addr,t)}function OS(i,e){let t=wo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function BS(i,e){let t=wo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function zS(i,e){let t=wo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function HS(i,e){i.uniform1iv(this.addr,e)}function VS(i,e){i.uniform2iv(this.addr,e)}function GS(i,e){i.uniform3iv(this.addr,e)}function WS(i,e){i.uniform4iv(this.addr,e)}function XS(i,e){i.uniform1uiv(this.addr,e)}function $S(i,e){i.uniform2uiv(this.addr,e)}function qS(i,e){i.uniform3uiv(this.addr,e)}function YS(i,e){i.uniform4uiv(this.addr,e)}function ZS(i,e,t){let n=this.cache,s=e.length,r=mh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||e0,r[o])}function KS(i,e,t){let n=this.cache,s=e.length,r=mh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||n0,r[o])}function JS(i,e,t){let n=this.cache,s=e.length,r=mh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||i0,r[o])}function jS(i,e,t){let n=this.cache,s=e.length,r=mh(t,s);an(n,r)||(i.uniform1iv(this.addr,r),ln(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||t0,r[o])}function QS(i){switch(i){case 5126:return NS;case 35664:return kS;case 35665:return FS;case 35666:return US;case 35674:return OS;case 35675:return BS;case 35676:return zS;case 5124:case 35670:return HS;case 35667:case 35671:return VS;case 35668:case 35672:return GS;case 35669:case 35673:return WS;case 5125:return XS;case 36294:return $S;case 36295:return qS;case 36296:return YS;case 35678:case 36198:case 36298:case 36306:case 35682:return ZS;case 35679:case 36299:case 36307:return KS;case 35680:case 36300:case 36308:case 36293:return JS;case 36289:case 36303:case 36311:case 36292:return jS}}var Qd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=DS(t.type)}},ef=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=QS(t.type)}},tf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},jd=/(\w+)(\])?(\[|\.)?/g;function Vg(i,e){i.seq.push(e),i.map[e.id]=e}function eE(i,e,t){let n=i.name,s=n.length;for(jd.lastIndex=0;;){let r=jd.exec(n),o=jd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Vg(t,c===void 0?new Qd(a,i,e):new ef(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new tf(a),Vg(t,u)),t=u}}}var vo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);eE(r,o,this)}}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Gg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var tE=37297,nE=0;function iE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Wg=new ot;function sE(i){_t._getMatrix(Wg,_t.workingColorSpace,i);let e=`mat3( ${Wg.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(i)){case ea:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Xg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+iE(i.getShaderSource(e),a)}else return r}function rE(i,e){let t=sE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function oE(i,e){let t;switch(e){case ig:t="Linear";break;case sg:t="Reinhard";break;case rg:t="Cineon";break;case og:t="ACESFilmic";break;case lg:t="AgX";break;case cg:t="Neutral";break;case ag:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var fh=new U;function aE(){_t.getLuminanceCoefficients(fh);let i=fh.x.toFixed(4),e=fh.y.toFixed(4),t=fh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function lE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Fa).join(`
`)}function cE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function hE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Fa(i){return i!==""}function $g(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function qg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var uE=/^[ \t]*#include +<([\w\d./]+)>/gm;function nf(i){return i.replace(uE,fE)}var dE=new Map;function fE(i,e){let t=ct[e];if(t===void 0){let n=dE.get(e);if(n!==void 0)t=ct[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return nf(t)}var pE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Yg(i){return i.replace(pE,mE)}function mE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Zg(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}function gE(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Sd?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===Fm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Wi&&(e="SHADOWMAP_TYPE_VSM"),e}function _E(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case mr:case gr:e="ENVMAP_TYPE_CUBE";break;case Ca:e="ENVMAP_TYPE_CUBE_UV";break}return e}function yE(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case gr:e="ENVMAP_MODE_REFRACTION";break}return e}function xE(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Ac:e="ENVMAP_BLENDING_MULTIPLY";break;case tg:e="ENVMAP_BLENDING_MIX";break;case ng:e="ENVMAP_BLENDING_ADD";break}return e}function vE(i){let e=i.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function bE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=gE(t),c=_E(t),h=yE(t),u=xE(t),d=vE(t),f=lE(t),g=cE(r),y=s.createProgram(),m,p,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Fa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Fa).join(`
`),p.length>0&&(p+=`
`)):(m=[Zg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Fa).join(`
`),p=[Zg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?ct.tonemapping_pars_fragment:"",t.toneMapping!==cs?oE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,rE("linearToOutputTexel",t.outputColorSpace),aE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Fa).join(`
`)),o=nf(o),o=$g(o,t),o=qg(o,t),a=nf(a),a=$g(a,t),a=qg(a,t),o=Yg(o),a=Yg(a),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,m=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===Bd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Bd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let w=b+m+o,x=b+p+a,P=Gg(s,s.VERTEX_SHADER,w),A=Gg(s,s.FRAGMENT_SHADER,x);s.attachShader(y,P),s.attachShader(y,A),t.index0AttributeName!==void 0?s.bindAttribLocation(y,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function D(R){if(i.debug.checkShaderErrors){let B=s.getProgramInfoLog(y)||"",V=s.getShaderInfoLog(P)||"",X=s.getShaderInfoLog(A)||"",$=B.trim(),q=V.trim(),Q=X.trim(),Z=!0,ae=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(Z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,y,P,A);else{let le=Xg(s,P,"vertex"),ye=Xg(s,A,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+$+`
`+le+`
`+ye)}else $!==""?console.warn("THREE.WebGLProgram: Program Info Log:",$):(q===""||Q==="")&&(ae=!1);ae&&(R.diagnostics={runnable:Z,programLog:$,vertexShader:{log:q,prefix:m},fragmentShader:{log:Q,prefix:p}})}s.deleteShader(P),s.deleteShader(A),F=new vo(s,y),T=hE(s,y)}let F;this.getUniforms=function(){return F===void 0&&D(this),F};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let S=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(y,tE)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=nE++,this.cacheKey=e,this.usedTimes=1,this.program=y,this.vertexShader=P,this.fragmentShader=A,this}var wE=0,sf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new rf(e),t.set(e,n)),n}},rf=class{constructor(e){this.id=wE++,this.code=e,this.usedTimes=0}};function ME(i,e,t,n,s,r,o){let a=new oo,l=new sf,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures,f=s.precision,g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function y(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,S,R,B,V){let X=B.fog,$=V.geometry,q=T.isMeshStandardMaterial?B.environment:null,Q=(T.isMeshStandardMaterial?t:e).get(T.envMap||q),Z=Q&&Q.mapping===Ca?Q.image.height:null,ae=g[T.type];T.precision!==null&&(f=s.getMaxPrecision(T.precision),f!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",f,"instead."));let le=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,ye=le!==void 0?le.length:0,we=0;$.morphAttributes.position!==void 0&&(we=1),$.morphAttributes.normal!==void 0&&(we=2),$.morphAttributes.color!==void 0&&(we=3);let _e,st,et,ee;if(ae){let yt=$i[ae];_e=yt.vertexShader,st=yt.fragmentShader}else _e=T.vertexShader,st=T.fragmentShader,l.update(T),et=l.getVertexShaderID(T),ee=l.getFragmentShaderID(T);let ne=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),He=V.isInstancedMesh===!0,xe=V.isBatchedMesh===!0,tt=!!T.map,Ut=!!T.matcap,N=!!Q,gt=!!T.aoMap,Ke=!!T.lightMap,Xe=!!T.bumpMap,ke=!!T.normalMap,At=!!T.displacementMap,Pe=!!T.emissiveMap,We=!!T.metalnessMap,Gt=!!T.roughnessMap,wt=T.anisotropy>0,I=T.clearcoat>0,v=T.dispersion>0,k=T.iridescence>0,J=T.sheen>0,ie=T.transmission>0,te=wt&&!!T.anisotropyMap,Fe=I&&!!T.clearcoatMap,ue=I&&!!T.clearcoatNormalMap,Le=I&&!!T.clearcoatRoughnessMap,Re=k&&!!T.iridescenceMap,oe=k&&!!T.iridescenceThicknessMap,ge=J&&!!T.sheenColorMap,ze=J&&!!T.sheenRoughnessMap,Oe=!!T.specularMap,ve=!!T.specularColorMap,je=!!T.specularIntensityMap,z=ie&&!!T.transmissionMap,de=ie&&!!T.thicknessMap,pe=!!T.gradientMap,Ie=!!T.alphaMap,he=T.alphaTest>0,re=!!T.alphaHash,Ue=!!T.extensions,nt=cs;T.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Pt={shaderID:ae,shaderType:T.type,shaderName:T.name,vertexShader:_e,fragmentShader:st,defines:T.defines,customVertexShaderID:et,customFragmentShaderID:ee,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:f,batching:xe,batchingColor:xe&&V._colorsTexture!==null,instancing:He,instancingColor:He&&V.instanceColor!==null,instancingMorph:He&&V.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:ne===null?i.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:ir,alphaToCoverage:!!T.alphaToCoverage,map:tt,matcap:Ut,envMap:N,envMapMode:N&&Q.mapping,envMapCubeUVHeight:Z,aoMap:gt,lightMap:Ke,bumpMap:Xe,normalMap:ke,displacementMap:d&&At,emissiveMap:Pe,normalMapObjectSpace:ke&&T.normalMapType===fg,normalMapTangentSpace:ke&&T.normalMapType===Ud,metalnessMap:We,roughnessMap:Gt,anisotropy:wt,anisotropyMap:te,clearcoat:I,clearcoatMap:Fe,clearcoatNormalMap:ue,clearcoatRoughnessMap:Le,dispersion:v,iridescence:k,iridescenceMap:Re,iridescenceThicknessMap:oe,sheen:J,sheenColorMap:ge,sheenRoughnessMap:ze,specularMap:Oe,specularColorMap:ve,specularIntensityMap:je,transmission:ie,transmissionMap:z,thicknessMap:de,gradientMap:pe,opaque:T.transparent===!1&&T.blending===tr&&T.alphaToCoverage===!1,alphaMap:Ie,alphaTest:he,alphaHash:re,combine:T.combine,mapUv:tt&&y(T.map.channel),aoMapUv:gt&&y(T.aoMap.channel),lightMapUv:Ke&&y(T.lightMap.channel),bumpMapUv:Xe&&y(T.bumpMap.channel),normalMapUv:ke&&y(T.normalMap.channel),displacementMapUv:At&&y(T.displacementMap.channel),emissiveMapUv:Pe&&y(T.emissiveMap.channel),metalnessMapUv:We&&y(T.metalnessMap.channel),roughnessMapUv:Gt&&y(T.roughnessMap.channel),anisotropyMapUv:te&&y(T.anisotropyMap.channel),clearcoatMapUv:Fe&&y(T.clearcoatMap.channel),clearcoatNormalMapUv:ue&&y(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Le&&y(T.clearcoatRoughnessMap.channel),iridescenceMapUv:Re&&y(T.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&y(T.iridescenceThicknessMap.channel),sheenColorMapUv:ge&&y(T.sheenColorMap.channel),sheenRoughnessMapUv:ze&&y(T.sheenRoughnessMap.channel),specularMapUv:Oe&&y(T.specularMap.channel),specularColorMapUv:ve&&y(T.specularColorMap.channel),specularIntensityMapUv:je&&y(T.specularIntensityMap.channel),transmissionMapUv:z&&y(T.transmissionMap.channel),thicknessMapUv:de&&y(T.thicknessMap.channel),alphaMapUv:Ie&&y(T.alphaMap.channel),vertexTangents:!!$.attributes.tangent&&(ke||wt),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,pointsUvs:V.isPoints===!0&&!!$.attributes.uv&&(tt||Ie),fog:!!X,useFog:T.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:T.flatShading===!0&&T.wireframe===!1,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Ee,skinning:V.isSkinnedMesh===!0,morphTargets:$.morphAttributes.position!==void 0,morphNormals:$.morphAttributes.normal!==void 0,morphColors:$.morphAttributes.color!==void 0,morphTargetsCount:ye,morphTextureStride:we,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:tt&&T.map.isVideoTexture===!0&&_t.getTransfer(T.map.colorSpace)===Ct,decodeVideoTextureEmissive:Pe&&T.emissiveMap.isVideoTexture===!0&&_t.getTransfer(T.emissiveMap.colorSpace)===Ct,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===hi,flipSided:T.side===Fn,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Ue&&T.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ue&&T.extensions.multiDraw===!0||xe)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return Pt.vertexUv1s=c.has(1),Pt.vertexUv2s=c.has(2),Pt.vertexUv3s=c.has(3),c.clear(),Pt}function p(T){let S=[];if(T.shaderID?S.push(T.shaderID):(S.push(T.customVertexShaderID),S.push(T.customFragmentShaderID)),T.defines!==void 0)for(let R in T.defines)S.push(R),S.push(T.defines[R]);return T.isRawShaderMaterial===!1&&(b(S,T),w(S,T),S.push(i.outputColorSpace)),S.push(T.customProgramCacheKey),S.join()}function b(T,S){T.push(S.precision),T.push(S.outputColorSpace),T.push(S.envMapMode),T.push(S.envMapCubeUVHeight),T.push(S.mapUv),T.push(S.alphaMapUv),T.push(S.lightMapUv),T.push(S.aoMapUv),T.push(S.bumpMapUv),T.push(S.normalMapUv),T.push(S.displacementMapUv),T.push(S.emissiveMapUv),T.push(S.metalnessMapUv),T.push(S.roughnessMapUv),T.push(S.anisotropyMapUv),T.push(S.clearcoatMapUv),T.push(S.clearcoatNormalMapUv),T.push(S.clearcoatRoughnessMapUv),T.push(S.iridescenceMapUv),T.push(S.iridescenceThicknessMapUv),T.push(S.sheenColorMapUv),T.push(S.sheenRoughnessMapUv),T.push(S.specularMapUv),T.push(S.specularColorMapUv),T.push(S.specularIntensityMapUv),T.push(S.transmissionMapUv),T.push(S.thicknessMapUv),T.push(S.combine),T.push(S.fogExp2),T.push(S.sizeAttenuation),T.push(S.morphTargetsCount),T.push(S.morphAttributeCount),T.push(S.numDirLights),T.push(S.numPointLights),T.push(S.numSpotLights),T.push(S.numSpotLightMaps),T.push(S.numHemiLights),T.push(S.numRectAreaLights),T.push(S.numDirLightShadows),T.push(S.numPointLightShadows),T.push(S.numSpotLightShadows),T.push(S.numSpotLightShadowsWithMaps),T.push(S.numLightProbes),T.push(S.shadowMapType),T.push(S.toneMapping),T.push(S.numClippingPlanes),T.push(S.numClipIntersection),T.push(S.depthPacking)}function w(T,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),S.gradientMap&&a.enable(22),T.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reversedDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),T.push(a.mask)}function x(T){let S=g[T.type],R;if(S){let B=$i[S];R=Sg.clone(B.uniforms)}else R=T.uniforms;return R}function P(T,S){let R;for(let B=0,V=h.length;B<V;B++){let X=h[B];if(X.cacheKey===S){R=X,++R.usedTimes;break}}return R===void 0&&(R=new bE(i,S,T,r),h.push(R)),R}function A(T){if(--T.usedTimes===0){let S=h.indexOf(T);h[S]=h[h.length-1],h.pop(),T.destroy()}}function D(T){l.remove(T)}function F(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:x,acquireProgram:P,releaseProgram:A,releaseShaderCache:D,programs:h,dispose:F}}function SE(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function EE(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Kg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Jg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u,d,f,g,y,m){let p=i[e];return p===void 0?(p={id:u.id,object:u,geometry:d,material:f,groupOrder:g,renderOrder:u.renderOrder,z:y,group:m},i[e]=p):(p.id=u.id,p.object=u,p.geometry=d,p.material=f,p.groupOrder=g,p.renderOrder=u.renderOrder,p.z=y,p.group=m),e++,p}function a(u,d,f,g,y,m){let p=o(u,d,f,g,y,m);f.transmission>0?n.push(p):f.transparent===!0?s.push(p):t.push(p)}function l(u,d,f,g,y,m){let p=o(u,d,f,g,y,m);f.transmission>0?n.unshift(p):f.transparent===!0?s.unshift(p):t.unshift(p)}function c(u,d){t.length>1&&t.sort(u||EE),n.length>1&&n.sort(d||Kg),s.length>1&&s.sort(d||Kg)}function h(){for(let u=e,d=i.length;u<d;u++){let f=i[u];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:h,sort:c}}function TE(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Jg,i.set(n,[o])):s>=r.length?(o=new Jg,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function AE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new U,color:new Ze};break;case"SpotLight":t={position:new U,direction:new U,color:new Ze,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new Ze,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new Ze,groundColor:new Ze};break;case"RectAreaLight":t={color:new Ze,position:new U,halfWidth:new U,halfHeight:new U};break}return i[e.id]=t,t}}}function RE(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new be,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var CE=0;function PE(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function IE(i){let e=new AE,t=RE(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new U);let s=new U,r=new Et,o=new Et;function a(c){let h=0,u=0,d=0;for(let T=0;T<9;T++)n.probe[T].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,b=0,w=0,x=0,P=0,A=0,D=0;c.sort(PE);for(let T=0,S=c.length;T<S;T++){let R=c[T],B=R.color,V=R.intensity,X=R.distance,$=R.shadow&&R.shadow.map?R.shadow.map.texture:null;if(R.isAmbientLight)h+=B.r*V,u+=B.g*V,d+=B.b*V;else if(R.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(R.sh.coefficients[q],V);D++}else if(R.isDirectionalLight){let q=e.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){let Q=R.shadow,Z=t.get(R);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,n.directionalShadow[f]=Z,n.directionalShadowMap[f]=$,n.directionalShadowMatrix[f]=R.shadow.matrix,b++}n.directional[f]=q,f++}else if(R.isSpotLight){let q=e.get(R);q.position.setFromMatrixPosition(R.matrixWorld),q.color.copy(B).multiplyScalar(V),q.distance=X,q.coneCos=Math.cos(R.angle),q.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),q.decay=R.decay,n.spot[y]=q;let Q=R.shadow;if(R.map&&(n.spotLightMap[P]=R.map,P++,Q.updateMatrices(R),R.castShadow&&A++),n.spotLightMatrix[y]=Q.matrix,R.castShadow){let Z=t.get(R);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,n.spotShadow[y]=Z,n.spotShadowMap[y]=$,x++}y++}else if(R.isRectAreaLight){let q=e.get(R);q.color.copy(B).multiplyScalar(V),q.halfWidth.set(R.width*.5,0,0),q.halfHeight.set(0,R.height*.5,0),n.rectArea[m]=q,m++}else if(R.isPointLight){let q=e.get(R);if(q.color.copy(R.color).multiplyScalar(R.intensity),q.distance=R.distance,q.decay=R.decay,R.castShadow){let Q=R.shadow,Z=t.get(R);Z.shadowIntensity=Q.intensity,Z.shadowBias=Q.bias,Z.shadowNormalBias=Q.normalBias,Z.shadowRadius=Q.radius,Z.shadowMapSize=Q.mapSize,Z.shadowCameraNear=Q.camera.near,Z.shadowCameraFar=Q.camera.far,n.pointShadow[g]=Z,n.pointShadowMap[g]=$,n.pointShadowMatrix[g]=R.shadow.matrix,w++}n.point[g]=q,g++}else if(R.isHemisphereLight){let q=e.get(R);q.skyColor.copy(R.color).multiplyScalar(V),q.groundColor.copy(R.groundColor).multiplyScalar(V),n.hemi[p]=q,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Se.LTC_FLOAT_1,n.rectAreaLTC2=Se.LTC_FLOAT_2):(n.rectAreaLTC1=Se.LTC_HALF_1,n.rectAreaLTC2=Se.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let F=n.hash;(F.directionalLength!==f||F.pointLength!==g||F.spotLength!==y||F.rectAreaLength!==m||F.hemiLength!==p||F.numDirectionalShadows!==b||F.numPointShadows!==w||F.numSpotShadows!==x||F.numSpotMaps!==P||F.numLightProbes!==D)&&(n.directional.length=f,n.spot.length=y,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=b,n.directionalShadowMap.length=b,n.pointShadow.length=w,n.pointShadowMap.length=w,n.spotShadow.length=x,n.spotShadowMap.length=x,n.directionalShadowMatrix.length=b,n.pointShadowMatrix.length=w,n.spotLightMatrix.length=x+P-A,n.spotLightMap.length=P,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=D,F.directionalLength=f,F.pointLength=g,F.spotLength=y,F.rectAreaLength=m,F.hemiLength=p,F.numDirectionalShadows=b,F.numPointShadows=w,F.numSpotShadows=x,F.numSpotMaps=P,F.numLightProbes=D,n.version=CE++)}function l(c,h){let u=0,d=0,f=0,g=0,y=0,m=h.matrixWorldInverse;for(let p=0,b=c.length;p<b;p++){let w=c[p];if(w.isDirectionalLight){let x=n.directional[u];x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),u++}else if(w.isSpotLight){let x=n.spot[f];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),x.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(m),f++}else if(w.isRectAreaLight){let x=n.rectArea[g];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),x.halfWidth.set(w.width*.5,0,0),x.halfHeight.set(0,w.height*.5,0),x.halfWidth.applyMatrix4(o),x.halfHeight.applyMatrix4(o),g++}else if(w.isPointLight){let x=n.point[d];x.position.setFromMatrixPosition(w.matrixWorld),x.position.applyMatrix4(m),d++}else if(w.isHemisphereLight){let x=n.hemi[y];x.direction.setFromMatrixPosition(w.matrixWorld),x.direction.transformDirection(m),y++}}}return{setup:a,setupView:l,state:n}}function jg(i){let e=new IE(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function r(h){t.push(h)}function o(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}let c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function LE(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new jg(i),e.set(s,[a])):r>=o.length?(a=new jg(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var DE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,NE=`uniform sampler2D shadow_pass;
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
}`;function kE(i,e,t){let n=new lo,s=new be,r=new be,o=new Jt,a=new cc({depthPacking:dg}),l=new hc,c={},h=t.maxTextureSize,u={[rs]:Fn,[Fn]:rs,[hi]:hi},d=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new be},radius:{value:4}},vertexShader:DE,fragmentShader:NE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Vt;g.setAttribute("position",new on(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new mt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Sd;let p=this.type;this.render=function(A,D,F){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;let T=i.getRenderTarget(),S=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),B=i.state;B.setBlending(ls),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let V=p!==Wi&&this.type===Wi,X=p===Wi&&this.type!==Wi;for(let $=0,q=A.length;$<q;$++){let Q=A[$],Z=Q.shadow;if(Z===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(Z.autoUpdate===!1&&Z.needsUpdate===!1)continue;s.copy(Z.mapSize);let ae=Z.getFrameExtents();if(s.multiply(ae),r.copy(Z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ae.x),s.x=r.x*ae.x,Z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ae.y),s.y=r.y*ae.y,Z.mapSize.y=r.y)),Z.map===null||V===!0||X===!0){let ye=this.type!==Wi?{minFilter:ci,magFilter:ci}:{};Z.map!==null&&Z.map.dispose(),Z.map=new Bi(s.x,s.y,ye),Z.map.texture.name=Q.name+".shadowMap",Z.camera.updateProjectionMatrix()}i.setRenderTarget(Z.map),i.clear();let le=Z.getViewportCount();for(let ye=0;ye<le;ye++){let we=Z.getViewport(ye);o.set(r.x*we.x,r.y*we.y,r.x*we.z,r.y*we.w),B.viewport(o),Z.updateMatrices(Q,ye),n=Z.getFrustum(),x(D,F,Z.camera,Q,this.type)}Z.isPointLightShadow!==!0&&this.type===Wi&&b(Z,F),Z.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(T,S,R)};function b(A,D){let F=e.update(y);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null&&(A.mapPass=new Bi(s.x,s.y)),d.uniforms.shadow_pass.value=A.map.texture,d.uniforms.resolution.value=A.mapSize,d.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(D,null,F,d,y,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value=A.mapSize,f.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(D,null,F,f,y,null)}function w(A,D,F,T){let S=null,R=F.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(R!==void 0)S=R;else if(S=F.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let B=S.uuid,V=D.uuid,X=c[B];X===void 0&&(X={},c[B]=X);let $=X[V];$===void 0&&($=S.clone(),X[V]=$,D.addEventListener("dispose",P)),S=$}if(S.visible=D.visible,S.wireframe=D.wireframe,T===Wi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:u[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,F.isPointLight===!0&&S.isMeshDistanceMaterial===!0){let B=i.properties.get(S);B.light=F}return S}function x(A,D,F,T,S){if(A.visible===!1)return;if(A.layers.test(D.layers)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&S===Wi)&&(!A.frustumCulled||n.intersectsObject(A))){A.modelViewMatrix.multiplyMatrices(F.matrixWorldInverse,A.matrixWorld);let V=e.update(A),X=A.material;if(Array.isArray(X)){let $=V.groups;for(let q=0,Q=$.length;q<Q;q++){let Z=$[q],ae=X[Z.materialIndex];if(ae&&ae.visible){let le=w(A,ae,T,S);A.onBeforeShadow(i,A,D,F,V,le,Z),i.renderBufferDirect(F,null,V,le,A,Z),A.onAfterShadow(i,A,D,F,V,le,Z)}}}else if(X.visible){let $=w(A,X,T,S);A.onBeforeShadow(i,A,D,F,V,$,null),i.renderBufferDirect(F,null,V,$,A,null),A.onAfterShadow(i,A,D,F,V,$,null)}}let B=A.children;for(let V=0,X=B.length;V<X;V++)x(B[V],D,F,T,S)}function P(A){A.target.removeEventListener("dispose",P);for(let F in c){let T=c[F],S=A.target.uuid;S in T&&(T[S].dispose(),delete T[S])}}}var FE={[vc]:bc,[wc]:Ec,[Mc]:Tc,[nr]:Sc,[bc]:vc,[Ec]:wc,[Tc]:Mc,[Sc]:nr};function UE(i,e){function t(){let z=!1,de=new Jt,pe=null,Ie=new Jt(0,0,0,0);return{setMask:function(he){pe!==he&&!z&&(i.colorMask(he,he,he,he),pe=he)},setLocked:function(he){z=he},setClear:function(he,re,Ue,nt,Pt){Pt===!0&&(he*=nt,re*=nt,Ue*=nt),de.set(he,re,Ue,nt),Ie.equals(de)===!1&&(i.clearColor(he,re,Ue,nt),Ie.copy(de))},reset:function(){z=!1,pe=null,Ie.set(-1,0,0,0)}}}function n(){let z=!1,de=!1,pe=null,Ie=null,he=null;return{setReversed:function(re){if(de!==re){let Ue=e.get("EXT_clip_control");re?Ue.clipControlEXT(Ue.LOWER_LEFT_EXT,Ue.ZERO_TO_ONE_EXT):Ue.clipControlEXT(Ue.LOWER_LEFT_EXT,Ue.NEGATIVE_ONE_TO_ONE_EXT),de=re;let nt=he;he=null,this.setClear(nt)}},getReversed:function(){return de},setTest:function(re){re?ne(i.DEPTH_TEST):Ee(i.DEPTH_TEST)},setMask:function(re){pe!==re&&!z&&(i.depthMask(re),pe=re)},setFunc:function(re){if(de&&(re=FE[re]),Ie!==re){switch(re){case vc:i.depthFunc(i.NEVER);break;case bc:i.depthFunc(i.ALWAYS);break;case wc:i.depthFunc(i.LESS);break;case nr:i.depthFunc(i.LEQUAL);break;case Mc:i.depthFunc(i.EQUAL);break;case Sc:i.depthFunc(i.GEQUAL);break;case Ec:i.depthFunc(i.GREATER);break;case Tc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ie=re}},setLocked:function(re){z=re},setClear:function(re){he!==re&&(de&&(re=1-re),i.clearDepth(re),he=re)},reset:function(){z=!1,pe=null,Ie=null,he=null,de=!1}}}function s(){let z=!1,de=null,pe=null,Ie=null,he=null,re=null,Ue=null,nt=null,Pt=null;return{setTest:function(yt){z||(yt?ne(i.STENCIL_TEST):Ee(i.STENCIL_TEST))},setMask:function(yt){de!==yt&&!z&&(i.stencilMask(yt),de=yt)},setFunc:function(yt,vn,Dt){(pe!==yt||Ie!==vn||he!==Dt)&&(i.stencilFunc(yt,vn,Dt),pe=yt,Ie=vn,he=Dt)},setOp:function(yt,vn,Dt){(re!==yt||Ue!==vn||nt!==Dt)&&(i.stencilOp(yt,vn,Dt),re=yt,Ue=vn,nt=Dt)},setLocked:function(yt){z=yt},setClear:function(yt){Pt!==yt&&(i.clearStencil(yt),Pt=yt)},reset:function(){z=!1,de=null,pe=null,Ie=null,he=null,re=null,Ue=null,nt=null,Pt=null}}}let r=new t,o=new n,a=new s,l=new WeakMap,c=new WeakMap,h={},u={},d=new WeakMap,f=[],g=null,y=!1,m=null,p=null,b=null,w=null,x=null,P=null,A=null,D=new Ze(0,0,0),F=0,T=!1,S=null,R=null,B=null,V=null,X=null,$=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),q=!1,Q=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(Z)[1]),q=Q>=1):Z.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),q=Q>=2);let ae=null,le={},ye=i.getParameter(i.SCISSOR_BOX),we=i.getParameter(i.VIEWPORT),_e=new Jt().fromArray(ye),st=new Jt().fromArray(we);function et(z,de,pe,Ie){let he=new Uint8Array(4),re=i.createTexture();i.bindTexture(z,re),i.texParameteri(z,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(z,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ue=0;Ue<pe;Ue++)z===i.TEXTURE_3D||z===i.TEXTURE_2D_ARRAY?i.texImage3D(de,0,i.RGBA,1,1,Ie,0,i.RGBA,i.UNSIGNED_BYTE,he):i.texImage2D(de+Ue,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,he);return re}let ee={};ee[i.TEXTURE_2D]=et(i.TEXTURE_2D,i.TEXTURE_2D,1),ee[i.TEXTURE_CUBE_MAP]=et(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ee[i.TEXTURE_2D_ARRAY]=et(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ee[i.TEXTURE_3D]=et(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ne(i.DEPTH_TEST),o.setFunc(nr),Xe(!1),ke(Md),ne(i.CULL_FACE),gt(ls);function ne(z){h[z]!==!0&&(i.enable(z),h[z]=!0)}function Ee(z){h[z]!==!1&&(i.disable(z),h[z]=!1)}function He(z,de){return u[z]!==de?(i.bindFramebuffer(z,de),u[z]=de,z===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=de),z===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=de),!0):!1}function xe(z,de){let pe=f,Ie=!1;if(z){pe=d.get(de),pe===void 0&&(pe=[],d.set(de,pe));let he=z.textures;if(pe.length!==he.length||pe[0]!==i.COLOR_ATTACHMENT0){for(let re=0,Ue=he.length;re<Ue;re++)pe[re]=i.COLOR_ATTACHMENT0+re;pe.length=he.length,Ie=!0}}else pe[0]!==i.BACK&&(pe[0]=i.BACK,Ie=!0);Ie&&i.drawBuffers(pe)}function tt(z){return g!==z?(i.useProgram(z),g=z,!0):!1}let Ut={[Cs]:i.FUNC_ADD,[Om]:i.FUNC_SUBTRACT,[Bm]:i.FUNC_REVERSE_SUBTRACT};Ut[zm]=i.MIN,Ut[Hm]=i.MAX;let N={[Vm]:i.ZERO,[Gm]:i.ONE,[Wm]:i.SRC_COLOR,[Xl]:i.SRC_ALPHA,[Km]:i.SRC_ALPHA_SATURATE,[Ym]:i.DST_COLOR,[$m]:i.DST_ALPHA,[Xm]:i.ONE_MINUS_SRC_COLOR,[$l]:i.ONE_MINUS_SRC_ALPHA,[Zm]:i.ONE_MINUS_DST_COLOR,[qm]:i.ONE_MINUS_DST_ALPHA,[Jm]:i.CONSTANT_COLOR,[jm]:i.ONE_MINUS_CONSTANT_COLOR,[Qm]:i.CONSTANT_ALPHA,[eg]:i.ONE_MINUS_CONSTANT_ALPHA};function gt(z,de,pe,Ie,he,re,Ue,nt,Pt,yt){if(z===ls){y===!0&&(Ee(i.BLEND),y=!1);return}if(y===!1&&(ne(i.BLEND),y=!0),z!==Um){if(z!==m||yt!==T){if((p!==Cs||x!==Cs)&&(i.blendEquation(i.FUNC_ADD),p=Cs,x=Cs),yt)switch(z){case tr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ed:i.blendFunc(i.ONE,i.ONE);break;case Td:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ad:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}else switch(z){case tr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ed:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Td:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ad:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",z);break}b=null,w=null,P=null,A=null,D.set(0,0,0),F=0,m=z,T=yt}return}he=he||de,re=re||pe,Ue=Ue||Ie,(de!==p||he!==x)&&(i.blendEquationSeparate(Ut[de],Ut[he]),p=de,x=he),(pe!==b||Ie!==w||re!==P||Ue!==A)&&(i.blendFuncSeparate(N[pe],N[Ie],N[re],N[Ue]),b=pe,w=Ie,P=re,A=Ue),(nt.equals(D)===!1||Pt!==F)&&(i.blendColor(nt.r,nt.g,nt.b,Pt),D.copy(nt),F=Pt),m=z,T=!1}function Ke(z,de){z.side===hi?Ee(i.CULL_FACE):ne(i.CULL_FACE);let pe=z.side===Fn;de&&(pe=!pe),Xe(pe),z.blending===tr&&z.transparent===!1?gt(ls):gt(z.blending,z.blendEquation,z.blendSrc,z.blendDst,z.blendEquationAlpha,z.blendSrcAlpha,z.blendDstAlpha,z.blendColor,z.blendAlpha,z.premultipliedAlpha),o.setFunc(z.depthFunc),o.setTest(z.depthTest),o.setMask(z.depthWrite),r.setMask(z.colorWrite);let Ie=z.stencilWrite;a.setTest(Ie),Ie&&(a.setMask(z.stencilWriteMask),a.setFunc(z.stencilFunc,z.stencilRef,z.stencilFuncMask),a.setOp(z.stencilFail,z.stencilZFail,z.stencilZPass)),Pe(z.polygonOffset,z.polygonOffsetFactor,z.polygonOffsetUnits),z.alphaToCoverage===!0?ne(i.SAMPLE_ALPHA_TO_COVERAGE):Ee(i.SAMPLE_ALPHA_TO_COVERAGE)}function Xe(z){S!==z&&(z?i.frontFace(i.CW):i.frontFace(i.CCW),S=z)}function ke(z){z!==Nm?(ne(i.CULL_FACE),z!==R&&(z===Md?i.cullFace(i.BACK):z===km?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ee(i.CULL_FACE),R=z}function At(z){z!==B&&(q&&i.lineWidth(z),B=z)}function Pe(z,de,pe){z?(ne(i.POLYGON_OFFSET_FILL),(V!==de||X!==pe)&&(i.polygonOffset(de,pe),V=de,X=pe)):Ee(i.POLYGON_OFFSET_FILL)}function We(z){z?ne(i.SCISSOR_TEST):Ee(i.SCISSOR_TEST)}function Gt(z){z===void 0&&(z=i.TEXTURE0+$-1),ae!==z&&(i.activeTexture(z),ae=z)}function wt(z,de,pe){pe===void 0&&(ae===null?pe=i.TEXTURE0+$-1:pe=ae);let Ie=le[pe];Ie===void 0&&(Ie={type:void 0,texture:void 0},le[pe]=Ie),(Ie.type!==z||Ie.texture!==de)&&(ae!==pe&&(i.activeTexture(pe),ae=pe),i.bindTexture(z,de||ee[z]),Ie.type=z,Ie.texture=de)}function I(){let z=le[ae];z!==void 0&&z.type!==void 0&&(i.bindTexture(z.type,null),z.type=void 0,z.texture=void 0)}function v(){try{i.compressedTexImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function k(){try{i.compressedTexImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function J(){try{i.texSubImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ie(){try{i.texSubImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function te(){try{i.compressedTexSubImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Fe(){try{i.compressedTexSubImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ue(){try{i.texStorage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Le(){try{i.texStorage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function Re(){try{i.texImage2D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function oe(){try{i.texImage3D(...arguments)}catch(z){console.error("THREE.WebGLState:",z)}}function ge(z){_e.equals(z)===!1&&(i.scissor(z.x,z.y,z.z,z.w),_e.copy(z))}function ze(z){st.equals(z)===!1&&(i.viewport(z.x,z.y,z.z,z.w),st.copy(z))}function Oe(z,de){let pe=c.get(de);pe===void 0&&(pe=new WeakMap,c.set(de,pe));let Ie=pe.get(z);Ie===void 0&&(Ie=i.getUniformBlockIndex(de,z.name),pe.set(z,Ie))}function ve(z,de){let Ie=c.get(de).get(z);l.get(de)!==Ie&&(i.uniformBlockBinding(de,Ie,z.__bindingPointIndex),l.set(de,Ie))}function je(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ae=null,le={},u={},d=new WeakMap,f=[],g=null,y=!1,m=null,p=null,b=null,w=null,x=null,P=null,A=null,D=new Ze(0,0,0),F=0,T=!1,S=null,R=null,B=null,V=null,X=null,_e.set(0,0,i.canvas.width,i.canvas.height),st.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ne,disable:Ee,bindFramebuffer:He,drawBuffers:xe,useProgram:tt,setBlending:gt,setMaterial:Ke,setFlipSided:Xe,setCullFace:ke,setLineWidth:At,setPolygonOffset:Pe,setScissorTest:We,activeTexture:Gt,bindTexture:wt,unbindTexture:I,compressedTexImage2D:v,compressedTexImage3D:k,texImage2D:Re,texImage3D:oe,updateUBOMapping:Oe,uniformBlockBinding:ve,texStorage2D:ue,texStorage3D:Le,texSubImage2D:J,texSubImage3D:ie,compressedTexSubImage2D:te,compressedTexSubImage3D:Fe,scissor:ge,viewport:ze,reset:je}}function OE(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new be,h=new WeakMap,u,d=new WeakMap,f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,v){return f?new OffscreenCanvas(I,v):na("canvas")}function y(I,v,k){let J=1,ie=wt(I);if((ie.width>k||ie.height>k)&&(J=k/Math.max(ie.width,ie.height)),J<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let te=Math.floor(J*ie.width),Fe=Math.floor(J*ie.height);u===void 0&&(u=g(te,Fe));let ue=v?g(te,Fe):u;return ue.width=te,ue.height=Fe,ue.getContext("2d").drawImage(I,0,0,te,Fe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ie.width+"x"+ie.height+") to ("+te+"x"+Fe+")."),ue}else return"data"in I&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ie.width+"x"+ie.height+")."),I;return I}function m(I){return I.generateMipmaps}function p(I){i.generateMipmap(I)}function b(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(I,v,k,J,ie=!1){if(I!==null){if(i[I]!==void 0)return i[I];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let te=v;if(v===i.RED&&(k===i.FLOAT&&(te=i.R32F),k===i.HALF_FLOAT&&(te=i.R16F),k===i.UNSIGNED_BYTE&&(te=i.R8)),v===i.RED_INTEGER&&(k===i.UNSIGNED_BYTE&&(te=i.R8UI),k===i.UNSIGNED_SHORT&&(te=i.R16UI),k===i.UNSIGNED_INT&&(te=i.R32UI),k===i.BYTE&&(te=i.R8I),k===i.SHORT&&(te=i.R16I),k===i.INT&&(te=i.R32I)),v===i.RG&&(k===i.FLOAT&&(te=i.RG32F),k===i.HALF_FLOAT&&(te=i.RG16F),k===i.UNSIGNED_BYTE&&(te=i.RG8)),v===i.RG_INTEGER&&(k===i.UNSIGNED_BYTE&&(te=i.RG8UI),k===i.UNSIGNED_SHORT&&(te=i.RG16UI),k===i.UNSIGNED_INT&&(te=i.RG32UI),k===i.BYTE&&(te=i.RG8I),k===i.SHORT&&(te=i.RG16I),k===i.INT&&(te=i.RG32I)),v===i.RGB_INTEGER&&(k===i.UNSIGNED_BYTE&&(te=i.RGB8UI),k===i.UNSIGNED_SHORT&&(te=i.RGB16UI),k===i.UNSIGNED_INT&&(te=i.RGB32UI),k===i.BYTE&&(te=i.RGB8I),k===i.SHORT&&(te=i.RGB16I),k===i.INT&&(te=i.RGB32I)),v===i.RGBA_INTEGER&&(k===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),k===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),k===i.UNSIGNED_INT&&(te=i.RGBA32UI),k===i.BYTE&&(te=i.RGBA8I),k===i.SHORT&&(te=i.RGBA16I),k===i.INT&&(te=i.RGBA32I)),v===i.RGB&&(k===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),k===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),v===i.RGBA){let Fe=ie?ea:_t.getTransfer(J);k===i.FLOAT&&(te=i.RGBA32F),k===i.HALF_FLOAT&&(te=i.RGBA16F),k===i.UNSIGNED_BYTE&&(te=Fe===Ct?i.SRGB8_ALPHA8:i.RGBA8),k===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),k===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(I,v){let k;return I?v===null||v===Fs||v===go?k=i.DEPTH24_STENCIL8:v===Xi?k=i.DEPTH32F_STENCIL8:v===po&&(k=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Fs||v===go?k=i.DEPTH_COMPONENT24:v===Xi?k=i.DEPTH_COMPONENT32F:v===po&&(k=i.DEPTH_COMPONENT16),k}function P(I,v){return m(I)===!0||I.isFramebufferTexture&&I.minFilter!==ci&&I.minFilter!==wi?Math.log2(Math.max(v.width,v.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?v.mipmaps.length:1}function A(I){let v=I.target;v.removeEventListener("dispose",A),F(v),v.isVideoTexture&&h.delete(v)}function D(I){let v=I.target;v.removeEventListener("dispose",D),S(v)}function F(I){let v=n.get(I);if(v.__webglInit===void 0)return;let k=I.source,J=d.get(k);if(J){let ie=J[v.__cacheKey];ie.usedTimes--,ie.usedTimes===0&&T(I),Object.keys(J).length===0&&d.delete(k)}n.remove(I)}function T(I){let v=n.get(I);i.deleteTexture(v.__webglTexture);let k=I.source,J=d.get(k);delete J[v.__cacheKey],o.memory.textures--}function S(I){let v=n.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),n.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(v.__webglFramebuffer[J]))for(let ie=0;ie<v.__webglFramebuffer[J].length;ie++)i.deleteFramebuffer(v.__webglFramebuffer[J][ie]);else i.deleteFramebuffer(v.__webglFramebuffer[J]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[J])}else{if(Array.isArray(v.__webglFramebuffer))for(let J=0;J<v.__webglFramebuffer.length;J++)i.deleteFramebuffer(v.__webglFramebuffer[J]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let J=0;J<v.__webglColorRenderbuffer.length;J++)v.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[J]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let k=I.textures;for(let J=0,ie=k.length;J<ie;J++){let te=n.get(k[J]);te.__webglTexture&&(i.deleteTexture(te.__webglTexture),o.memory.textures--),n.remove(k[J])}n.remove(I)}let R=0;function B(){R=0}function V(){let I=R;return I>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),R+=1,I}function X(I){let v=[];return v.push(I.wrapS),v.push(I.wrapT),v.push(I.wrapR||0),v.push(I.magFilter),v.push(I.minFilter),v.push(I.anisotropy),v.push(I.internalFormat),v.push(I.format),v.push(I.type),v.push(I.generateMipmaps),v.push(I.premultiplyAlpha),v.push(I.flipY),v.push(I.unpackAlignment),v.push(I.colorSpace),v.join()}function $(I,v){let k=n.get(I);if(I.isVideoTexture&&We(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&k.__version!==I.version){let J=I.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ee(k,I,v);return}}else I.isExternalTexture&&(k.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,k.__webglTexture,i.TEXTURE0+v)}function q(I,v){let k=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&k.__version!==I.version){ee(k,I,v);return}t.bindTexture(i.TEXTURE_2D_ARRAY,k.__webglTexture,i.TEXTURE0+v)}function Q(I,v){let k=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&k.__version!==I.version){ee(k,I,v);return}t.bindTexture(i.TEXTURE_3D,k.__webglTexture,i.TEXTURE0+v)}function Z(I,v){let k=n.get(I);if(I.version>0&&k.__version!==I.version){ne(k,I,v);return}t.bindTexture(i.TEXTURE_CUBE_MAP,k.__webglTexture,i.TEXTURE0+v)}let ae={[ql]:i.REPEAT,[Rs]:i.CLAMP_TO_EDGE,[Yl]:i.MIRRORED_REPEAT},le={[ci]:i.NEAREST,[hg]:i.NEAREST_MIPMAP_NEAREST,[Pa]:i.NEAREST_MIPMAP_LINEAR,[wi]:i.LINEAR,[Pc]:i.LINEAR_MIPMAP_NEAREST,[ks]:i.LINEAR_MIPMAP_LINEAR},ye={[pg]:i.NEVER,[vg]:i.ALWAYS,[mg]:i.LESS,[Od]:i.LEQUAL,[gg]:i.EQUAL,[xg]:i.GEQUAL,[_g]:i.GREATER,[yg]:i.NOTEQUAL};function we(I,v){if(v.type===Xi&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===wi||v.magFilter===Pc||v.magFilter===Pa||v.magFilter===ks||v.minFilter===wi||v.minFilter===Pc||v.minFilter===Pa||v.minFilter===ks)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,ae[v.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,ae[v.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,ae[v.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,le[v.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,le[v.minFilter]),v.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,ye[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===ci||v.minFilter!==Pa&&v.minFilter!==ks||v.type===Xi&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let k=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function _e(I,v){let k=!1;I.__webglInit===void 0&&(I.__webglInit=!0,v.addEventListener("dispose",A));let J=v.source,ie=d.get(J);ie===void 0&&(ie={},d.set(J,ie));let te=X(v);if(te!==I.__cacheKey){ie[te]===void 0&&(ie[te]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,k=!0),ie[te].usedTimes++;let Fe=ie[I.__cacheKey];Fe!==void 0&&(ie[I.__cacheKey].usedTimes--,Fe.usedTimes===0&&T(v)),I.__cacheKey=te,I.__webglTexture=ie[te].texture}return k}function st(I,v,k){return Math.floor(Math.floor(I/k)/v)}function et(I,v,k,J){let te=I.updateRanges;if(te.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,k,J,v.data);else{te.sort((oe,ge)=>oe.start-ge.start);let Fe=0;for(let oe=1;oe<te.length;oe++){let ge=te[Fe],ze=te[oe],Oe=ge.start+ge.count,ve=st(ze.start,v.width,4),je=st(ge.start,v.width,4);ze.start<=Oe+1&&ve===je&&st(ze.start+ze.count-1,v.width,4)===ve?ge.count=Math.max(ge.count,ze.start+ze.count-ge.start):(++Fe,te[Fe]=ze)}te.length=Fe+1;let ue=i.getParameter(i.UNPACK_ROW_LENGTH),Le=i.getParameter(i.UNPACK_SKIP_PIXELS),Re=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let oe=0,ge=te.length;oe<ge;oe++){let ze=te[oe],Oe=Math.floor(ze.start/4),ve=Math.ceil(ze.count/4),je=Oe%v.width,z=Math.floor(Oe/v.width),de=ve,pe=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,je),i.pixelStorei(i.UNPACK_SKIP_ROWS,z),t.texSubImage2D(i.TEXTURE_2D,0,je,z,de,pe,k,J,v.data)}I.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ue),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Le),i.pixelStorei(i.UNPACK_SKIP_ROWS,Re)}}function ee(I,v,k){let J=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(J=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(J=i.TEXTURE_3D);let ie=_e(I,v),te=v.source;t.bindTexture(J,I.__webglTexture,i.TEXTURE0+k);let Fe=n.get(te);if(te.version!==Fe.__version||ie===!0){t.activeTexture(i.TEXTURE0+k);let ue=_t.getPrimaries(_t.workingColorSpace),Le=v.colorSpace===hs?null:_t.getPrimaries(v.colorSpace),Re=v.colorSpace===hs||ue===Le?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Re);let oe=y(v.image,!1,s.maxTextureSize);oe=Gt(v,oe);let ge=r.convert(v.format,v.colorSpace),ze=r.convert(v.type),Oe=w(v.internalFormat,ge,ze,v.colorSpace,v.isVideoTexture);we(J,v);let ve,je=v.mipmaps,z=v.isVideoTexture!==!0,de=Fe.__version===void 0||ie===!0,pe=te.dataReady,Ie=P(v,oe);if(v.isDepthTexture)Oe=x(v.format===_o,v.type),de&&(z?t.texStorage2D(i.TEXTURE_2D,1,Oe,oe.width,oe.height):t.texImage2D(i.TEXTURE_2D,0,Oe,oe.width,oe.height,0,ge,ze,null));else if(v.isDataTexture)if(je.length>0){z&&de&&t.texStorage2D(i.TEXTURE_2D,Ie,Oe,je[0].width,je[0].height);for(let he=0,re=je.length;he<re;he++)ve=je[he],z?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ve.width,ve.height,ge,ze,ve.data):t.texImage2D(i.TEXTURE_2D,he,Oe,ve.width,ve.height,0,ge,ze,ve.data);v.generateMipmaps=!1}else z?(de&&t.texStorage2D(i.TEXTURE_2D,Ie,Oe,oe.width,oe.height),pe&&et(v,oe,ge,ze)):t.texImage2D(i.TEXTURE_2D,0,Oe,oe.width,oe.height,0,ge,ze,oe.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){z&&de&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ie,Oe,je[0].width,je[0].height,oe.depth);for(let he=0,re=je.length;he<re;he++)if(ve=je[he],v.format!==ui)if(ge!==null)if(z){if(pe)if(v.layerUpdates.size>0){let Ue=$d(ve.width,ve.height,v.format,v.type);for(let nt of v.layerUpdates){let Pt=ve.data.subarray(nt*Ue/ve.data.BYTES_PER_ELEMENT,(nt+1)*Ue/ve.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,nt,ve.width,ve.height,1,ge,Pt)}v.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ve.width,ve.height,oe.depth,ge,ve.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,Oe,ve.width,ve.height,oe.depth,0,ve.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else z?pe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ve.width,ve.height,oe.depth,ge,ze,ve.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,Oe,ve.width,ve.height,oe.depth,0,ge,ze,ve.data)}else{z&&de&&t.texStorage2D(i.TEXTURE_2D,Ie,Oe,je[0].width,je[0].height);for(let he=0,re=je.length;he<re;he++)ve=je[he],v.format!==ui?ge!==null?z?pe&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ve.width,ve.height,ge,ve.data):t.compressedTexImage2D(i.TEXTURE_2D,he,Oe,ve.width,ve.height,0,ve.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):z?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ve.width,ve.height,ge,ze,ve.data):t.texImage2D(i.TEXTURE_2D,he,Oe,ve.width,ve.height,0,ge,ze,ve.data)}else if(v.isDataArrayTexture)if(z){if(de&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ie,Oe,oe.width,oe.height,oe.depth),pe)if(v.layerUpdates.size>0){let he=$d(oe.width,oe.height,v.format,v.type);for(let re of v.layerUpdates){let Ue=oe.data.subarray(re*he/oe.data.BYTES_PER_ELEMENT,(re+1)*he/oe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,re,oe.width,oe.height,1,ge,ze,Ue)}v.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,oe.width,oe.height,oe.depth,ge,ze,oe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Oe,oe.width,oe.height,oe.depth,0,ge,ze,oe.data);else if(v.isData3DTexture)z?(de&&t.texStorage3D(i.TEXTURE_3D,Ie,Oe,oe.width,oe.height,oe.depth),pe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,oe.width,oe.height,oe.depth,ge,ze,oe.data)):t.texImage3D(i.TEXTURE_3D,0,Oe,oe.width,oe.height,oe.depth,0,ge,ze,oe.data);else if(v.isFramebufferTexture){if(de)if(z)t.texStorage2D(i.TEXTURE_2D,Ie,Oe,oe.width,oe.height);else{let he=oe.width,re=oe.height;for(let Ue=0;Ue<Ie;Ue++)t.texImage2D(i.TEXTURE_2D,Ue,Oe,he,re,0,ge,ze,null),he>>=1,re>>=1}}else if(je.length>0){if(z&&de){let he=wt(je[0]);t.texStorage2D(i.TEXTURE_2D,Ie,Oe,he.width,he.height)}for(let he=0,re=je.length;he<re;he++)ve=je[he],z?pe&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ge,ze,ve):t.texImage2D(i.TEXTURE_2D,he,Oe,ge,ze,ve);v.generateMipmaps=!1}else if(z){if(de){let he=wt(oe);t.texStorage2D(i.TEXTURE_2D,Ie,Oe,he.width,he.height)}pe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ge,ze,oe)}else t.texImage2D(i.TEXTURE_2D,0,Oe,ge,ze,oe);m(v)&&p(J),Fe.__version=te.version,v.onUpdate&&v.onUpdate(v)}I.__version=v.version}function ne(I,v,k){if(v.image.length!==6)return;let J=_e(I,v),ie=v.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+k);let te=n.get(ie);if(ie.version!==te.__version||J===!0){t.activeTexture(i.TEXTURE0+k);let Fe=_t.getPrimaries(_t.workingColorSpace),ue=v.colorSpace===hs?null:_t.getPrimaries(v.colorSpace),Le=v.colorSpace===hs||Fe===ue?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Le);let Re=v.isCompressedTexture||v.image[0].isCompressedTexture,oe=v.image[0]&&v.image[0].isDataTexture,ge=[];for(let re=0;re<6;re++)!Re&&!oe?ge[re]=y(v.image[re],!0,s.maxCubemapSize):ge[re]=oe?v.image[re].image:v.image[re],ge[re]=Gt(v,ge[re]);let ze=ge[0],Oe=r.convert(v.format,v.colorSpace),ve=r.convert(v.type),je=w(v.internalFormat,Oe,ve,v.colorSpace),z=v.isVideoTexture!==!0,de=te.__version===void 0||J===!0,pe=ie.dataReady,Ie=P(v,ze);we(i.TEXTURE_CUBE_MAP,v);let he;if(Re){z&&de&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,je,ze.width,ze.height);for(let re=0;re<6;re++){he=ge[re].mipmaps;for(let Ue=0;Ue<he.length;Ue++){let nt=he[Ue];v.format!==ui?Oe!==null?z?pe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue,0,0,nt.width,nt.height,Oe,nt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue,je,nt.width,nt.height,0,nt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):z?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue,0,0,nt.width,nt.height,Oe,ve,nt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue,je,nt.width,nt.height,0,Oe,ve,nt.data)}}}else{if(he=v.mipmaps,z&&de){he.length>0&&Ie++;let re=wt(ge[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ie,je,re.width,re.height)}for(let re=0;re<6;re++)if(oe){z?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ge[re].width,ge[re].height,Oe,ve,ge[re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,je,ge[re].width,ge[re].height,0,Oe,ve,ge[re].data);for(let Ue=0;Ue<he.length;Ue++){let Pt=he[Ue].image[re].image;z?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue+1,0,0,Pt.width,Pt.height,Oe,ve,Pt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue+1,je,Pt.width,Pt.height,0,Oe,ve,Pt.data)}}else{z?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,Oe,ve,ge[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,je,Oe,ve,ge[re]);for(let Ue=0;Ue<he.length;Ue++){let nt=he[Ue];z?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue+1,0,0,Oe,ve,nt.image[re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+re,Ue+1,je,Oe,ve,nt.image[re])}}}m(v)&&p(i.TEXTURE_CUBE_MAP),te.__version=ie.version,v.onUpdate&&v.onUpdate(v)}I.__version=v.version}function Ee(I,v,k,J,ie,te){let Fe=r.convert(k.format,k.colorSpace),ue=r.convert(k.type),Le=w(k.internalFormat,Fe,ue,k.colorSpace),Re=n.get(v),oe=n.get(k);if(oe.__renderTarget=v,!Re.__hasExternalTextures){let ge=Math.max(1,v.width>>te),ze=Math.max(1,v.height>>te);ie===i.TEXTURE_3D||ie===i.TEXTURE_2D_ARRAY?t.texImage3D(ie,te,Le,ge,ze,v.depth,0,Fe,ue,null):t.texImage2D(ie,te,Le,ge,ze,0,Fe,ue,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Pe(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,J,ie,oe.__webglTexture,0,At(v)):(ie===i.TEXTURE_2D||ie>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ie<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,J,ie,oe.__webglTexture,te),t.bindFramebuffer(i.FRAMEBUFFER,null)}function He(I,v,k){if(i.bindRenderbuffer(i.RENDERBUFFER,I),v.depthBuffer){let J=v.depthTexture,ie=J&&J.isDepthTexture?J.type:null,te=x(v.stencilBuffer,ie),Fe=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=At(v);Pe(v)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ue,te,v.width,v.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,ue,te,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,te,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Fe,i.RENDERBUFFER,I)}else{let J=v.textures;for(let ie=0;ie<J.length;ie++){let te=J[ie],Fe=r.convert(te.format,te.colorSpace),ue=r.convert(te.type),Le=w(te.internalFormat,Fe,ue,te.colorSpace),Re=At(v);k&&Pe(v)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Re,Le,v.width,v.height):Pe(v)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Re,Le,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Le,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(I,v){if(v&&v.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let J=n.get(v.depthTexture);J.__renderTarget=v,(!J.__webglTexture||v.depthTexture.image.width!==v.width||v.depthTexture.image.height!==v.height)&&(v.depthTexture.image.width=v.width,v.depthTexture.image.height=v.height,v.depthTexture.needsUpdate=!0),$(v.depthTexture,0);let ie=J.__webglTexture,te=At(v);if(v.depthTexture.format===no)Pe(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,ie,0);else if(v.depthTexture.format===_o)Pe(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,ie,0);else throw new Error("Unknown depthTexture format")}function tt(I){let v=n.get(I),k=I.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==I.depthTexture){let J=I.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),J){let ie=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,J.removeEventListener("dispose",ie)};J.addEventListener("dispose",ie),v.__depthDisposeCallback=ie}v.__boundDepthTexture=J}if(I.depthTexture&&!v.__autoAllocateDepthBuffer){if(k)throw new Error("target.depthTexture not supported in Cube render targets");let J=I.texture.mipmaps;J&&J.length>0?xe(v.__webglFramebuffer[0],I):xe(v.__webglFramebuffer,I)}else if(k){v.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[J]),v.__webglDepthbuffer[J]===void 0)v.__webglDepthbuffer[J]=i.createRenderbuffer(),He(v.__webglDepthbuffer[J],I,!1);else{let ie=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=v.__webglDepthbuffer[J];i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}else{let J=I.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),He(v.__webglDepthbuffer,I,!1);else{let ie=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,te=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ie,i.RENDERBUFFER,te)}}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Ut(I,v,k){let J=n.get(I);v!==void 0&&Ee(J.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),k!==void 0&&tt(I)}function N(I){let v=I.texture,k=n.get(I),J=n.get(v);I.addEventListener("dispose",D);let ie=I.textures,te=I.isWebGLCubeRenderTarget===!0,Fe=ie.length>1;if(Fe||(J.__webglTexture===void 0&&(J.__webglTexture=i.createTexture()),J.__version=v.version,o.memory.textures++),te){k.__webglFramebuffer=[];for(let ue=0;ue<6;ue++)if(v.mipmaps&&v.mipmaps.length>0){k.__webglFramebuffer[ue]=[];for(let Le=0;Le<v.mipmaps.length;Le++)k.__webglFramebuffer[ue][Le]=i.createFramebuffer()}else k.__webglFramebuffer[ue]=i.createFramebuffer()}else{if(v.mipmaps&&v.mipmaps.length>0){k.__webglFramebuffer=[];for(let ue=0;ue<v.mipmaps.length;ue++)k.__webglFramebuffer[ue]=i.createFramebuffer()}else k.__webglFramebuffer=i.createFramebuffer();if(Fe)for(let ue=0,Le=ie.length;ue<Le;ue++){let Re=n.get(ie[ue]);Re.__webglTexture===void 0&&(Re.__webglTexture=i.createTexture(),o.memory.textures++)}if(I.samples>0&&Pe(I)===!1){k.__webglMultisampledFramebuffer=i.createFramebuffer(),k.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let ue=0;ue<ie.length;ue++){let Le=ie[ue];k.__webglColorRenderbuffer[ue]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,k.__webglColorRenderbuffer[ue]);let Re=r.convert(Le.format,Le.colorSpace),oe=r.convert(Le.type),ge=w(Le.internalFormat,Re,oe,Le.colorSpace,I.isXRRenderTarget===!0),ze=At(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,ze,ge,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.RENDERBUFFER,k.__webglColorRenderbuffer[ue])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(k.__webglDepthRenderbuffer=i.createRenderbuffer(),He(k.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(te){t.bindTexture(i.TEXTURE_CUBE_MAP,J.__webglTexture),we(i.TEXTURE_CUBE_MAP,v);for(let ue=0;ue<6;ue++)if(v.mipmaps&&v.mipmaps.length>0)for(let Le=0;Le<v.mipmaps.length;Le++)Ee(k.__webglFramebuffer[ue][Le],I,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ue,Le);else Ee(k.__webglFramebuffer[ue],I,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ue,0);m(v)&&p(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Fe){for(let ue=0,Le=ie.length;ue<Le;ue++){let Re=ie[ue],oe=n.get(Re),ge=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ge=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ge,oe.__webglTexture),we(ge,Re),Ee(k.__webglFramebuffer,I,Re,i.COLOR_ATTACHMENT0+ue,ge,0),m(Re)&&p(ge)}t.unbindTexture()}else{let ue=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ue=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ue,J.__webglTexture),we(ue,v),v.mipmaps&&v.mipmaps.length>0)for(let Le=0;Le<v.mipmaps.length;Le++)Ee(k.__webglFramebuffer[Le],I,v,i.COLOR_ATTACHMENT0,ue,Le);else Ee(k.__webglFramebuffer,I,v,i.COLOR_ATTACHMENT0,ue,0);m(v)&&p(ue),t.unbindTexture()}I.depthBuffer&&tt(I)}function gt(I){let v=I.textures;for(let k=0,J=v.length;k<J;k++){let ie=v[k];if(m(ie)){let te=b(I),Fe=n.get(ie).__webglTexture;t.bindTexture(te,Fe),p(te),t.unbindTexture()}}}let Ke=[],Xe=[];function ke(I){if(I.samples>0){if(Pe(I)===!1){let v=I.textures,k=I.width,J=I.height,ie=i.COLOR_BUFFER_BIT,te=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Fe=n.get(I),ue=v.length>1;if(ue)for(let Re=0;Re<v.length;Re++)t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer);let Le=I.texture.mipmaps;Le&&Le.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Re=0;Re<v.length;Re++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(ie|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(ie|=i.STENCIL_BUFFER_BIT)),ue){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);let oe=n.get(v[Re]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,oe,0)}i.blitFramebuffer(0,0,k,J,0,0,k,J,ie,i.NEAREST),l===!0&&(Ke.length=0,Xe.length=0,Ke.push(i.COLOR_ATTACHMENT0+Re),I.depthBuffer&&I.resolveDepthBuffer===!1&&(Ke.push(te),Xe.push(te),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Xe)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ke))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ue)for(let Re=0;Re<v.length;Re++){t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);let oe=n.get(v[Re]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,oe,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&l){let v=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function At(I){return Math.min(s.maxSamples,I.samples)}function Pe(I){let v=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function We(I){let v=o.render.frame;h.get(I)!==v&&(h.set(I,v),I.update())}function Gt(I,v){let k=I.colorSpace,J=I.format,ie=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||k!==ir&&k!==hs&&(_t.getTransfer(k)===Ct?(J!==ui||ie!==Ti)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",k)),v}function wt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=V,this.resetTextureUnits=B,this.setTexture2D=$,this.setTexture2DArray=q,this.setTexture3D=Q,this.setTextureCube=Z,this.rebindTextures=Ut,this.setupRenderTarget=N,this.updateRenderTargetMipmap=gt,this.updateMultisampleRenderTarget=ke,this.setupDepthRenderbuffer=tt,this.setupFrameBufferTexture=Ee,this.useMultisampledRTT=Pe}function BE(i,e){function t(n,s=hs){let r,o=_t.getTransfer(s);if(n===Ti)return i.UNSIGNED_BYTE;if(n===Lc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Dc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Id)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ld)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Cd)return i.BYTE;if(n===Pd)return i.SHORT;if(n===po)return i.UNSIGNED_SHORT;if(n===Ic)return i.INT;if(n===Fs)return i.UNSIGNED_INT;if(n===Xi)return i.FLOAT;if(n===mo)return i.HALF_FLOAT;if(n===Dd)return i.ALPHA;if(n===Nd)return i.RGB;if(n===ui)return i.RGBA;if(n===no)return i.DEPTH_COMPONENT;if(n===_o)return i.DEPTH_STENCIL;if(n===kd)return i.RED;if(n===Nc)return i.RED_INTEGER;if(n===Fd)return i.RG;if(n===kc)return i.RG_INTEGER;if(n===Fc)return i.RGBA_INTEGER;if(n===Ia||n===La||n===Da||n===Na)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ia)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ia)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===La)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Da)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Na)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Uc||n===Oc||n===Bc||n===zc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Uc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Oc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Bc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Hc||n===Vc||n===Gc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Hc||n===Vc)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Gc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Wc||n===Xc||n===$c||n===qc||n===Yc||n===Zc||n===Kc||n===Jc||n===jc||n===Qc||n===eh||n===th||n===nh||n===ih)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Wc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Xc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===$c)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===qc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Yc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Zc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Kc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Jc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===jc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Qc)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===eh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===th)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===nh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ih)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===sh||n===rh||n===oh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===sh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===rh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===oh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ah||n===lh||n===ch||n===hh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===lh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ch)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===hh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===go?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var zE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,HE=`
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

}`,of=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ua(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Mi({vertexShader:zE,fragmentShader:HE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new mt(new lr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},af=class extends Oi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new of,p={},b=t.getContextAttributes(),w=null,x=null,P=[],A=[],D=new be,F=null,T=new xn;T.viewport=new Jt;let S=new xn;S.viewport=new Jt;let R=[T,S],B=new xc,V=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ne=P[ee];return ne===void 0&&(ne=new ao,P[ee]=ne),ne.getTargetRaySpace()},this.getControllerGrip=function(ee){let ne=P[ee];return ne===void 0&&(ne=new ao,P[ee]=ne),ne.getGripSpace()},this.getHand=function(ee){let ne=P[ee];return ne===void 0&&(ne=new ao,P[ee]=ne),ne.getHandSpace()};function $(ee){let ne=A.indexOf(ee.inputSource);if(ne===-1)return;let Ee=P[ne];Ee!==void 0&&(Ee.update(ee.inputSource,ee.frame,c||o),Ee.dispatchEvent({type:ee.type,data:ee.inputSource}))}function q(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",Q);for(let ee=0;ee<P.length;ee++){let ne=A[ee];ne!==null&&(A[ee]=null,P[ee].disconnect(ne))}V=null,X=null,m.reset();for(let ee in p)delete p[ee];e.setRenderTarget(w),f=null,d=null,u=null,s=null,x=null,et.stop(),n.isPresenting=!1,e.setPixelRatio(F),e.setSize(D.width,D.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",q),s.addEventListener("inputsourceschange",Q),b.xrCompatible!==!0&&await t.makeXRCompatible(),F=e.getPixelRatio(),e.getSize(D),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ee=null,He=null,xe=null;b.depth&&(xe=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ee=b.stencil?_o:no,He=b.stencil?go:Fs);let tt={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(tt),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),x=new Bi(d.textureWidth,d.textureHeight,{format:ui,type:Ti,depthTexture:new ha(d.textureWidth,d.textureHeight,He,void 0,void 0,void 0,void 0,void 0,void 0,Ee),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{let Ee={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Ee),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),x=new Bi(f.framebufferWidth,f.framebufferHeight,{format:ui,type:Ti,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),et.setContext(s),et.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Q(ee){for(let ne=0;ne<ee.removed.length;ne++){let Ee=ee.removed[ne],He=A.indexOf(Ee);He>=0&&(A[He]=null,P[He].disconnect(Ee))}for(let ne=0;ne<ee.added.length;ne++){let Ee=ee.added[ne],He=A.indexOf(Ee);if(He===-1){for(let tt=0;tt<P.length;tt++)if(tt>=A.length){A.push(Ee),He=tt;break}else if(A[tt]===null){A[tt]=Ee,He=tt;break}if(He===-1)break}let xe=P[He];xe&&xe.connect(Ee)}}let Z=new U,ae=new U;function le(ee,ne,Ee){Z.setFromMatrixPosition(ne.matrixWorld),ae.setFromMatrixPosition(Ee.matrixWorld);let He=Z.distanceTo(ae),xe=ne.projectionMatrix.elements,tt=Ee.projectionMatrix.elements,Ut=xe[14]/(xe[10]-1),N=xe[14]/(xe[10]+1),gt=(xe[9]+1)/xe[5],Ke=(xe[9]-1)/xe[5],Xe=(xe[8]-1)/xe[0],ke=(tt[8]+1)/tt[0],At=Ut*Xe,Pe=Ut*ke,We=He/(-Xe+ke),Gt=We*-Xe;if(ne.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(Gt),ee.translateZ(We),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),xe[10]===-1)ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse);else{let wt=Ut+We,I=N+We,v=At-Gt,k=Pe+(He-Gt),J=gt*N/I*wt,ie=Ke*N/I*wt;ee.projectionMatrix.makePerspective(v,k,J,ie,wt,I),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function ye(ee,ne){ne===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ne.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ne=ee.near,Ee=ee.far;m.texture!==null&&(m.depthNear>0&&(ne=m.depthNear),m.depthFar>0&&(Ee=m.depthFar)),B.near=S.near=T.near=ne,B.far=S.far=T.far=Ee,(V!==B.near||X!==B.far)&&(s.updateRenderState({depthNear:B.near,depthFar:B.far}),V=B.near,X=B.far),B.layers.mask=ee.layers.mask|6,T.layers.mask=B.layers.mask&3,S.layers.mask=B.layers.mask&5;let He=ee.parent,xe=B.cameras;ye(B,He);for(let tt=0;tt<xe.length;tt++)ye(xe[tt],He);xe.length===2?le(B,T,S):B.projectionMatrix.copy(T.projectionMatrix),we(ee,B,He)};function we(ee,ne,Ee){Ee===null?ee.matrix.copy(ne.matrixWorld):(ee.matrix.copy(Ee.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ne.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ne.projectionMatrix),ee.projectionMatrixInverse.copy(ne.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=io*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(B)},this.getCameraTexture=function(ee){return p[ee]};let _e=null;function st(ee,ne){if(h=ne.getViewerPose(c||o),g=ne,h!==null){let Ee=h.views;f!==null&&(e.setRenderTargetFramebuffer(x,f.framebuffer),e.setRenderTarget(x));let He=!1;Ee.length!==B.cameras.length&&(B.cameras.length=0,He=!0);for(let N=0;N<Ee.length;N++){let gt=Ee[N],Ke=null;if(f!==null)Ke=f.getViewport(gt);else{let ke=u.getViewSubImage(d,gt);Ke=ke.viewport,N===0&&(e.setRenderTargetTextures(x,ke.colorTexture,ke.depthStencilTexture),e.setRenderTarget(x))}let Xe=R[N];Xe===void 0&&(Xe=new xn,Xe.layers.enable(N),Xe.viewport=new Jt,R[N]=Xe),Xe.matrix.fromArray(gt.transform.matrix),Xe.matrix.decompose(Xe.position,Xe.quaternion,Xe.scale),Xe.projectionMatrix.fromArray(gt.projectionMatrix),Xe.projectionMatrixInverse.copy(Xe.projectionMatrix).invert(),Xe.viewport.set(Ke.x,Ke.y,Ke.width,Ke.height),N===0&&(B.matrix.copy(Xe.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),He===!0&&B.cameras.push(Xe)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let N=u.getDepthInformation(Ee[0]);N&&N.isValid&&N.texture&&m.init(N,s.renderState)}if(xe&&xe.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let N=0;N<Ee.length;N++){let gt=Ee[N].camera;if(gt){let Ke=p[gt];Ke||(Ke=new ua,p[gt]=Ke);let Xe=u.getCameraImage(gt);Ke.sourceTexture=Xe}}}}for(let Ee=0;Ee<P.length;Ee++){let He=A[Ee],xe=P[Ee];He!==null&&xe!==void 0&&xe.update(He,ne,c||o)}_e&&_e(ee,ne),ne.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ne}),g=null}let et=new Qg;et.setAnimationLoop(st),this.setAnimationLoop=function(ee){_e=ee},this.dispose=function(){}}},vr=new Zn,VE=new Et;function GE(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Vd(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,b,w,x){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,x)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,b,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Fn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Fn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let b=e.get(p),w=b.envMap,x=b.envMapRotation;w&&(m.envMap.value=w,vr.copy(x),vr.x*=-1,vr.y*=-1,vr.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(vr.y*=-1,vr.z*=-1),m.envMapRotation.value.setFromMatrix4(VE.makeRotationFromEuler(vr)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,b,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*b,m.scale.value=w*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,b){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Fn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=b.texture,m.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let b=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(b.matrixWorld),m.nearDistance.value=b.shadow.camera.near,m.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function WE(i,e,t,n){let s={},r={},o=[],a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(b,w){let x=w.program;n.uniformBlockBinding(b,x)}function c(b,w){let x=s[b.id];x===void 0&&(g(b),x=h(b),s[b.id]=x,b.addEventListener("dispose",m));let P=w.program;n.updateUBOMapping(b,P);let A=e.render.frame;r[b.id]!==A&&(d(b),r[b.id]=A)}function h(b){let w=u();b.__bindingPointIndex=w;let x=i.createBuffer(),P=b.__size,A=b.usage;return i.bindBuffer(i.UNIFORM_BUFFER,x),i.bufferData(i.UNIFORM_BUFFER,P,A),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,w,x),x}function u(){for(let b=0;b<a;b++)if(o.indexOf(b)===-1)return o.push(b),b;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(b){let w=s[b.id],x=b.uniforms,P=b.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let A=0,D=x.length;A<D;A++){let F=Array.isArray(x[A])?x[A]:[x[A]];for(let T=0,S=F.length;T<S;T++){let R=F[T];if(f(R,A,T,P)===!0){let B=R.__offset,V=Array.isArray(R.value)?R.value:[R.value],X=0;for(let $=0;$<V.length;$++){let q=V[$],Q=y(q);typeof q=="number"||typeof q=="boolean"?(R.__data[0]=q,i.bufferSubData(i.UNIFORM_BUFFER,B+X,R.__data)):q.isMatrix3?(R.__data[0]=q.elements[0],R.__data[1]=q.elements[1],R.__data[2]=q.elements[2],R.__data[3]=0,R.__data[4]=q.elements[3],R.__data[5]=q.elements[4],R.__data[6]=q.elements[5],R.__data[7]=0,R.__data[8]=q.elements[6],R.__data[9]=q.elements[7],R.__data[10]=q.elements[8],R.__data[11]=0):(q.toArray(R.__data,X),X+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,B,R.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function f(b,w,x,P){let A=b.value,D=w+"_"+x;if(P[D]===void 0)return typeof A=="number"||typeof A=="boolean"?P[D]=A:P[D]=A.clone(),!0;{let F=P[D];if(typeof A=="number"||typeof A=="boolean"){if(F!==A)return P[D]=A,!0}else if(F.equals(A)===!1)return F.copy(A),!0}return!1}function g(b){let w=b.uniforms,x=0,P=16;for(let D=0,F=w.length;D<F;D++){let T=Array.isArray(w[D])?w[D]:[w[D]];for(let S=0,R=T.length;S<R;S++){let B=T[S],V=Array.isArray(B.value)?B.value:[B.value];for(let X=0,$=V.length;X<$;X++){let q=V[X],Q=y(q),Z=x%P,ae=Z%Q.boundary,le=Z+ae;x+=ae,le!==0&&P-le<Q.storage&&(x+=P-le),B.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),B.__offset=x,x+=Q.storage}}}let A=x%P;return A>0&&(x+=P-A),b.__size=x,b.__cache={},this}function y(b){let w={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(w.boundary=4,w.storage=4):b.isVector2?(w.boundary=8,w.storage=8):b.isVector3||b.isColor?(w.boundary=16,w.storage=12):b.isVector4?(w.boundary=16,w.storage=16):b.isMatrix3?(w.boundary=48,w.storage=48):b.isMatrix4?(w.boundary=64,w.storage=64):b.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",b),w}function m(b){let w=b.target;w.removeEventListener("dispose",m);let x=o.indexOf(w.__bindingPointIndex);o.splice(x,1),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(let b in s)i.deleteBuffer(s[b]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var bo=class{constructor(e={}){let{canvas:t=bg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let f;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=n.getContextAttributes().alpha}else f=o;let g=new Uint32Array(4),y=new Int32Array(4),m=null,p=null,b=[],w=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let x=this,P=!1;this._outputColorSpace=Ht;let A=0,D=0,F=null,T=-1,S=null,R=new Jt,B=new Jt,V=null,X=new Ze(0),$=0,q=t.width,Q=t.height,Z=1,ae=null,le=null,ye=new Jt(0,0,q,Q),we=new Jt(0,0,q,Q),_e=!1,st=new lo,et=!1,ee=!1,ne=new Et,Ee=new U,He=new Jt,xe={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tt=!1;function Ut(){return F===null?Z:1}let N=n;function gt(E,G){return t.getContext(E,G)}try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"180"}`),t.addEventListener("webglcontextlost",pe,!1),t.addEventListener("webglcontextrestored",Ie,!1),t.addEventListener("webglcontextcreationerror",he,!1),N===null){let G="webgl2";if(N=gt(G,E),N===null)throw gt(G)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(E){throw console.error("THREE.WebGLRenderer: "+E.message),E}let Ke,Xe,ke,At,Pe,We,Gt,wt,I,v,k,J,ie,te,Fe,ue,Le,Re,oe,ge,ze,Oe,ve,je;function z(){Ke=new lS(N),Ke.init(),Oe=new BE(N,Ke),Xe=new tS(N,Ke,e,Oe),ke=new UE(N,Ke),Xe.reversedDepthBuffer&&d&&ke.buffers.depth.setReversed(!0),At=new uS(N),Pe=new SE,We=new OE(N,Ke,ke,Pe,Xe,Oe,At),Gt=new iS(x),wt=new aS(x),I=new _b(N),ve=new QM(N,I),v=new cS(N,I,At,ve),k=new fS(N,v,I,At),oe=new dS(N,Xe,We),ue=new nS(Pe),J=new ME(x,Gt,wt,Ke,Xe,ve,ue),ie=new GE(x,Pe),te=new TE,Fe=new LE(Ke),Re=new jM(x,Gt,wt,ke,k,f,l),Le=new kE(x,k,Xe),je=new WE(N,At,Xe,ke),ge=new eS(N,Ke,At),ze=new hS(N,Ke,At),At.programs=J.programs,x.capabilities=Xe,x.extensions=Ke,x.properties=Pe,x.renderLists=te,x.shadowMap=Le,x.state=ke,x.info=At}z();let de=new af(x,N);this.xr=de,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let E=Ke.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ke.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Z},this.setPixelRatio=function(E){E!==void 0&&(Z=E,this.setSize(q,Q,!1))},this.getSize=function(E){return E.set(q,Q)},this.setSize=function(E,G,j=!0){if(de.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}q=E,Q=G,t.width=Math.floor(E*Z),t.height=Math.floor(G*Z),j===!0&&(t.style.width=E+"px",t.style.height=G+"px"),this.setViewport(0,0,E,G)},this.getDrawingBufferSize=function(E){return E.set(q*Z,Q*Z).floor()},this.setDrawingBufferSize=function(E,G,j){q=E,Q=G,Z=j,t.width=Math.floor(E*j),t.height=Math.floor(G*j),this.setViewport(0,0,E,G)},this.getCurrentViewport=function(E){return E.copy(R)},this.getViewport=function(E){return E.copy(ye)},this.setViewport=function(E,G,j,K){E.isVector4?ye.set(E.x,E.y,E.z,E.w):ye.set(E,G,j,K),ke.viewport(R.copy(ye).multiplyScalar(Z).round())},this.getScissor=function(E){return E.copy(we)},this.setScissor=function(E,G,j,K){E.isVector4?we.set(E.x,E.y,E.z,E.w):we.set(E,G,j,K),ke.scissor(B.copy(we).multiplyScalar(Z).round())},this.getScissorTest=function(){return _e},this.setScissorTest=function(E){ke.setScissorTest(_e=E)},this.setOpaqueSort=function(E){ae=E},this.setTransparentSort=function(E){le=E},this.getClearColor=function(E){return E.copy(Re.getClearColor())},this.setClearColor=function(){Re.setClearColor(...arguments)},this.getClearAlpha=function(){return Re.getClearAlpha()},this.setClearAlpha=function(){Re.setClearAlpha(...arguments)},this.clear=function(E=!0,G=!0,j=!0){let K=0;if(E){let W=!1;if(F!==null){let fe=F.texture.format;W=fe===Fc||fe===kc||fe===Nc}if(W){let fe=F.texture.type,Me=fe===Ti||fe===Fs||fe===po||fe===go||fe===Lc||fe===Dc,De=Re.getClearColor(),Te=Re.getClearAlpha(),qe=De.r,Ye=De.g,Ve=De.b;Me?(g[0]=qe,g[1]=Ye,g[2]=Ve,g[3]=Te,N.clearBufferuiv(N.COLOR,0,g)):(y[0]=qe,y[1]=Ye,y[2]=Ve,y[3]=Te,N.clearBufferiv(N.COLOR,0,y))}else K|=N.COLOR_BUFFER_BIT}G&&(K|=N.DEPTH_BUFFER_BIT),j&&(K|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),N.clear(K)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",pe,!1),t.removeEventListener("webglcontextrestored",Ie,!1),t.removeEventListener("webglcontextcreationerror",he,!1),Re.dispose(),te.dispose(),Fe.dispose(),Pe.dispose(),Gt.dispose(),wt.dispose(),k.dispose(),ve.dispose(),je.dispose(),J.dispose(),de.dispose(),de.removeEventListener("sessionstart",Dt),de.removeEventListener("sessionend",Hn),On.stop()};function pe(E){E.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),P=!0}function Ie(){console.log("THREE.WebGLRenderer: Context Restored."),P=!1;let E=At.autoReset,G=Le.enabled,j=Le.autoUpdate,K=Le.needsUpdate,W=Le.type;z(),At.autoReset=E,Le.enabled=G,Le.autoUpdate=j,Le.needsUpdate=K,Le.type=W}function he(E){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function re(E){let G=E.target;G.removeEventListener("dispose",re),Ue(G)}function Ue(E){nt(E),Pe.remove(E)}function nt(E){let G=Pe.get(E).programs;G!==void 0&&(G.forEach(function(j){J.releaseProgram(j)}),E.isShaderMaterial&&J.releaseShaderCache(E))}this.renderBufferDirect=function(E,G,j,K,W,fe){G===null&&(G=xe);let Me=W.isMesh&&W.matrixWorld.determinant()<0,De=Zi(E,G,j,K,W);ke.setMaterial(K,Me);let Te=j.index,qe=1;if(K.wireframe===!0){if(Te=v.getWireframeAttribute(j),Te===void 0)return;qe=2}let Ye=j.drawRange,Ve=j.attributes.position,at=Ye.start*qe,xt=(Ye.start+Ye.count)*qe;fe!==null&&(at=Math.max(at,fe.start*qe),xt=Math.min(xt,(fe.start+fe.count)*qe)),Te!==null?(at=Math.max(at,0),xt=Math.min(xt,Te.count)):Ve!=null&&(at=Math.max(at,0),xt=Math.min(xt,Ve.count));let Ot=xt-at;if(Ot<0||Ot===1/0)return;ve.setup(W,K,De,j,Te);let Rt,rt=ge;if(Te!==null&&(Rt=I.get(Te),rt=ze,rt.setIndex(Rt)),W.isMesh)K.wireframe===!0?(ke.setLineWidth(K.wireframeLinewidth*Ut()),rt.setMode(N.LINES)):rt.setMode(N.TRIANGLES);else if(W.isLine){let $e=K.linewidth;$e===void 0&&($e=1),ke.setLineWidth($e*Ut()),W.isLineSegments?rt.setMode(N.LINES):W.isLineLoop?rt.setMode(N.LINE_LOOP):rt.setMode(N.LINE_STRIP)}else W.isPoints?rt.setMode(N.POINTS):W.isSprite&&rt.setMode(N.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)so("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),rt.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(Ke.get("WEBGL_multi_draw"))rt.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{let $e=W._multiDrawStarts,Bt=W._multiDrawCounts,dt=W._multiDrawCount,Sn=Te?I.get(Te).bytesPerElement:1,fs=Pe.get(K).currentProgram.getUniforms();for(let Pn=0;Pn<dt;Pn++)fs.setValue(N,"_gl_DrawID",Pn),rt.render($e[Pn]/Sn,Bt[Pn])}else if(W.isInstancedMesh)rt.renderInstances(at,Ot,W.count);else if(j.isInstancedBufferGeometry){let $e=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Bt=Math.min(j.instanceCount,$e);rt.renderInstances(at,Ot,Bt)}else rt.render(at,Ot)};function Pt(E,G,j){E.transparent===!0&&E.side===hi&&E.forceSinglePass===!1?(E.side=Fn,E.needsUpdate=!0,Hs(E,G,j),E.side=rs,E.needsUpdate=!0,Hs(E,G,j),E.side=hi):Hs(E,G,j)}this.compile=function(E,G,j=null){j===null&&(j=E),p=Fe.get(j),p.init(G),w.push(p),j.traverseVisible(function(W){W.isLight&&W.layers.test(G.layers)&&(p.pushLight(W),W.castShadow&&p.pushShadow(W))}),E!==j&&E.traverseVisible(function(W){W.isLight&&W.layers.test(G.layers)&&(p.pushLight(W),W.castShadow&&p.pushShadow(W))}),p.setupLights();let K=new Set;return E.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;let fe=W.material;if(fe)if(Array.isArray(fe))for(let Me=0;Me<fe.length;Me++){let De=fe[Me];Pt(De,j,W),K.add(De)}else Pt(fe,j,W),K.add(fe)}),p=w.pop(),K},this.compileAsync=function(E,G,j=null){let K=this.compile(E,G,j);return new Promise(W=>{function fe(){if(K.forEach(function(Me){Pe.get(Me).currentProgram.isReady()&&K.delete(Me)}),K.size===0){W(E);return}setTimeout(fe,10)}Ke.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let yt=null;function vn(E){yt&&yt(E)}function Dt(){On.stop()}function Hn(){On.start()}let On=new Qg;On.setAnimationLoop(vn),typeof self<"u"&&On.setContext(self),this.setAnimationLoop=function(E){yt=E,de.setAnimationLoop(E),E===null?On.stop():On.start()},de.addEventListener("sessionstart",Dt),de.addEventListener("sessionend",Hn),this.render=function(E,G){if(G!==void 0&&G.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),de.enabled===!0&&de.isPresenting===!0&&(de.cameraAutoUpdate===!0&&de.updateCamera(G),G=de.getCamera()),E.isScene===!0&&E.onBeforeRender(x,E,G,F),p=Fe.get(E,w.length),p.init(G),w.push(p),ne.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),st.setFromProjectionMatrix(ne,bi,G.reversedDepth),ee=this.localClippingEnabled,et=ue.init(this.clippingPlanes,ee),m=te.get(E,b.length),m.init(),b.push(m),de.enabled===!0&&de.isPresenting===!0){let fe=x.xr.getDepthSensingMesh();fe!==null&&Ii(fe,G,-1/0,x.sortObjects)}Ii(E,G,0,x.sortObjects),m.finish(),x.sortObjects===!0&&m.sort(ae,le),tt=de.enabled===!1||de.isPresenting===!1||de.hasDepthSensing()===!1,tt&&Re.addToRenderList(m,E),this.info.render.frame++,et===!0&&ue.beginShadows();let j=p.state.shadowsArray;Le.render(j,E,G),et===!0&&ue.endShadows(),this.info.autoReset===!0&&this.info.reset();let K=m.opaque,W=m.transmissive;if(p.setupLights(),G.isArrayCamera){let fe=G.cameras;if(W.length>0)for(let Me=0,De=fe.length;Me<De;Me++){let Te=fe[Me];Yi(K,W,E,Te)}tt&&Re.render(E);for(let Me=0,De=fe.length;Me<De;Me++){let Te=fe[Me];Cn(m,E,Te,Te.viewport)}}else W.length>0&&Yi(K,W,E,G),tt&&Re.render(E),Cn(m,E,G);F!==null&&D===0&&(We.updateMultisampleRenderTarget(F),We.updateRenderTargetMipmap(F)),E.isScene===!0&&E.onAfterRender(x,E,G),ve.resetDefaultState(),T=-1,S=null,w.pop(),w.length>0?(p=w[w.length-1],et===!0&&ue.setGlobalState(x.clippingPlanes,p.state.camera)):p=null,b.pop(),b.length>0?m=b[b.length-1]:m=null};function Ii(E,G,j,K){if(E.visible===!1)return;if(E.layers.test(G.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(G);else if(E.isLight)p.pushLight(E),E.castShadow&&p.pushShadow(E);else if(E.isSprite){if(!E.frustumCulled||st.intersectsSprite(E)){K&&He.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ne);let Me=k.update(E),De=E.material;De.visible&&m.push(E,Me,De,j,He.z,null)}}else if((E.isMesh||E.isLine||E.isPoints)&&(!E.frustumCulled||st.intersectsObject(E))){let Me=k.update(E),De=E.material;if(K&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),He.copy(E.boundingSphere.center)):(Me.boundingSphere===null&&Me.computeBoundingSphere(),He.copy(Me.boundingSphere.center)),He.applyMatrix4(E.matrixWorld).applyMatrix4(ne)),Array.isArray(De)){let Te=Me.groups;for(let qe=0,Ye=Te.length;qe<Ye;qe++){let Ve=Te[qe],at=De[Ve.materialIndex];at&&at.visible&&m.push(E,Me,at,j,He.z,Ve)}}else De.visible&&m.push(E,Me,De,j,He.z,null)}}let fe=E.children;for(let Me=0,De=fe.length;Me<De;Me++)Ii(fe[Me],G,j,K)}function Cn(E,G,j,K){let W=E.opaque,fe=E.transmissive,Me=E.transparent;p.setupLightsView(j),et===!0&&ue.setGlobalState(x.clippingPlanes,j),K&&ke.viewport(R.copy(K)),W.length>0&&mi(W,G,j),fe.length>0&&mi(fe,G,j),Me.length>0&&mi(Me,G,j),ke.buffers.depth.setTest(!0),ke.buffers.depth.setMask(!0),ke.buffers.color.setMask(!0),ke.setPolygonOffset(!1)}function Yi(E,G,j,K){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[K.id]===void 0&&(p.state.transmissionRenderTarget[K.id]=new Bi(1,1,{generateMipmaps:!0,type:Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float")?mo:Ti,minFilter:ks,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_t.workingColorSpace}));let fe=p.state.transmissionRenderTarget[K.id],Me=K.viewport||R;fe.setSize(Me.z*x.transmissionResolutionScale,Me.w*x.transmissionResolutionScale);let De=x.getRenderTarget(),Te=x.getActiveCubeFace(),qe=x.getActiveMipmapLevel();x.setRenderTarget(fe),x.getClearColor(X),$=x.getClearAlpha(),$<1&&x.setClearColor(16777215,.5),x.clear(),tt&&Re.render(j);let Ye=x.toneMapping;x.toneMapping=cs;let Ve=K.viewport;if(K.viewport!==void 0&&(K.viewport=void 0),p.setupLightsView(K),et===!0&&ue.setGlobalState(x.clippingPlanes,K),mi(E,j,K),We.updateMultisampleRenderTarget(fe),We.updateRenderTargetMipmap(fe),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let at=!1;for(let xt=0,Ot=G.length;xt<Ot;xt++){let Rt=G[xt],rt=Rt.object,$e=Rt.geometry,Bt=Rt.material,dt=Rt.group;if(Bt.side===hi&&rt.layers.test(K.layers)){let Sn=Bt.side;Bt.side=Fn,Bt.needsUpdate=!0,No(rt,j,K,$e,Bt,dt),Bt.side=Sn,Bt.needsUpdate=!0,at=!0}}at===!0&&(We.updateMultisampleRenderTarget(fe),We.updateRenderTargetMipmap(fe))}x.setRenderTarget(De,Te,qe),x.setClearColor(X,$),Ve!==void 0&&(K.viewport=Ve),x.toneMapping=Ye}function mi(E,G,j){let K=G.isScene===!0?G.overrideMaterial:null;for(let W=0,fe=E.length;W<fe;W++){let Me=E[W],De=Me.object,Te=Me.geometry,qe=Me.group,Ye=Me.material;Ye.allowOverride===!0&&K!==null&&(Ye=K),De.layers.test(j.layers)&&No(De,G,j,Te,Ye,qe)}}function No(E,G,j,K,W,fe){E.onBeforeRender(x,G,j,K,W,fe),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),W.onBeforeRender(x,G,j,K,E,fe),W.transparent===!0&&W.side===hi&&W.forceSinglePass===!1?(W.side=Fn,W.needsUpdate=!0,x.renderBufferDirect(j,G,K,W,E,fe),W.side=rs,W.needsUpdate=!0,x.renderBufferDirect(j,G,K,W,E,fe),W.side=hi):x.renderBufferDirect(j,G,K,W,E,fe),E.onAfterRender(x,G,j,K,W,fe)}function Hs(E,G,j){G.isScene!==!0&&(G=xe);let K=Pe.get(E),W=p.state.lights,fe=p.state.shadowsArray,Me=W.state.version,De=J.getParameters(E,W.state,fe,G,j),Te=J.getProgramCacheKey(De),qe=K.programs;K.environment=E.isMeshStandardMaterial?G.environment:null,K.fog=G.fog,K.envMap=(E.isMeshStandardMaterial?wt:Gt).get(E.envMap||K.environment),K.envMapRotation=K.environment!==null&&E.envMap===null?G.environmentRotation:E.envMapRotation,qe===void 0&&(E.addEventListener("dispose",re),qe=new Map,K.programs=qe);let Ye=qe.get(Te);if(Ye!==void 0){if(K.currentProgram===Ye&&K.lightsStateVersion===Me)return nl(E,De),Ye}else De.uniforms=J.getUniforms(E),E.onBeforeCompile(De,x),Ye=J.acquireProgram(De,Te),qe.set(Te,Ye),K.uniforms=De.uniforms;let Ve=K.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Ve.clippingPlanes=ue.uniform),nl(E,De),K.needsLights=Vs(E),K.lightsStateVersion=Me,K.needsLights&&(Ve.ambientLightColor.value=W.state.ambient,Ve.lightProbe.value=W.state.probe,Ve.directionalLights.value=W.state.directional,Ve.directionalLightShadows.value=W.state.directionalShadow,Ve.spotLights.value=W.state.spot,Ve.spotLightShadows.value=W.state.spotShadow,Ve.rectAreaLights.value=W.state.rectArea,Ve.ltc_1.value=W.state.rectAreaLTC1,Ve.ltc_2.value=W.state.rectAreaLTC2,Ve.pointLights.value=W.state.point,Ve.pointLightShadows.value=W.state.pointShadow,Ve.hemisphereLights.value=W.state.hemi,Ve.directionalShadowMap.value=W.state.directionalShadowMap,Ve.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Ve.spotShadowMap.value=W.state.spotShadowMap,Ve.spotLightMatrix.value=W.state.spotLightMatrix,Ve.spotLightMap.value=W.state.spotLightMap,Ve.pointShadowMap.value=W.state.pointShadowMap,Ve.pointShadowMatrix.value=W.state.pointShadowMatrix),K.currentProgram=Ye,K.uniformsList=null,Ye}function tl(E){if(E.uniformsList===null){let G=E.currentProgram.getUniforms();E.uniformsList=vo.seqWithValue(G.seq,E.uniforms)}return E.uniformsList}function nl(E,G){let j=Pe.get(E);j.outputColorSpace=G.outputColorSpace,j.batching=G.batching,j.batchingColor=G.batchingColor,j.instancing=G.instancing,j.instancingColor=G.instancingColor,j.instancingMorph=G.instancingMorph,j.skinning=G.skinning,j.morphTargets=G.morphTargets,j.morphNormals=G.morphNormals,j.morphColors=G.morphColors,j.morphTargetsCount=G.morphTargetsCount,j.numClippingPlanes=G.numClippingPlanes,j.numIntersection=G.numClipIntersection,j.vertexAlphas=G.vertexAlphas,j.vertexTangents=G.vertexTangents,j.toneMapping=G.toneMapping}function Zi(E,G,j,K,W){G.isScene!==!0&&(G=xe),We.resetTextureUnits();let fe=G.fog,Me=K.isMeshStandardMaterial?G.environment:null,De=F===null?x.outputColorSpace:F.isXRRenderTarget===!0?F.texture.colorSpace:ir,Te=(K.isMeshStandardMaterial?wt:Gt).get(K.envMap||Me),qe=K.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,Ye=!!j.attributes.tangent&&(!!K.normalMap||K.anisotropy>0),Ve=!!j.morphAttributes.position,at=!!j.morphAttributes.normal,xt=!!j.morphAttributes.color,Ot=cs;K.toneMapped&&(F===null||F.isXRRenderTarget===!0)&&(Ot=x.toneMapping);let Rt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,rt=Rt!==void 0?Rt.length:0,$e=Pe.get(K),Bt=p.state.lights;if(et===!0&&(ee===!0||E!==S)){let dn=E===S&&K.id===T;ue.setState(K,E,dn)}let dt=!1;K.version===$e.__version?($e.needsLights&&$e.lightsStateVersion!==Bt.state.version||$e.outputColorSpace!==De||W.isBatchedMesh&&$e.batching===!1||!W.isBatchedMesh&&$e.batching===!0||W.isBatchedMesh&&$e.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&$e.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&$e.instancing===!1||!W.isInstancedMesh&&$e.instancing===!0||W.isSkinnedMesh&&$e.skinning===!1||!W.isSkinnedMesh&&$e.skinning===!0||W.isInstancedMesh&&$e.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&$e.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&$e.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&$e.instancingMorph===!1&&W.morphTexture!==null||$e.envMap!==Te||K.fog===!0&&$e.fog!==fe||$e.numClippingPlanes!==void 0&&($e.numClippingPlanes!==ue.numPlanes||$e.numIntersection!==ue.numIntersection)||$e.vertexAlphas!==qe||$e.vertexTangents!==Ye||$e.morphTargets!==Ve||$e.morphNormals!==at||$e.morphColors!==xt||$e.toneMapping!==Ot||$e.morphTargetsCount!==rt)&&(dt=!0):(dt=!0,$e.__version=K.version);let Sn=$e.currentProgram;dt===!0&&(Sn=Hs(K,G,W));let fs=!1,Pn=!1,Gs=!1,zt=Sn.getUniforms(),In=$e.uniforms;if(ke.useProgram(Sn.program)&&(fs=!0,Pn=!0,Gs=!0),K.id!==T&&(T=K.id,Pn=!0),fs||S!==E){ke.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),zt.setValue(N,"projectionMatrix",E.projectionMatrix),zt.setValue(N,"viewMatrix",E.matrixWorldInverse);let fn=zt.map.cameraPosition;fn!==void 0&&fn.setValue(N,Ee.setFromMatrixPosition(E.matrixWorld)),Xe.logarithmicDepthBuffer&&zt.setValue(N,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(K.isMeshPhongMaterial||K.isMeshToonMaterial||K.isMeshLambertMaterial||K.isMeshBasicMaterial||K.isMeshStandardMaterial||K.isShaderMaterial)&&zt.setValue(N,"isOrthographic",E.isOrthographicCamera===!0),S!==E&&(S=E,Pn=!0,Gs=!0)}if(W.isSkinnedMesh){zt.setOptional(N,W,"bindMatrix"),zt.setOptional(N,W,"bindMatrixInverse");let dn=W.skeleton;dn&&(dn.boneTexture===null&&dn.computeBoneTexture(),zt.setValue(N,"boneTexture",dn.boneTexture,We))}W.isBatchedMesh&&(zt.setOptional(N,W,"batchingTexture"),zt.setValue(N,"batchingTexture",W._matricesTexture,We),zt.setOptional(N,W,"batchingIdTexture"),zt.setValue(N,"batchingIdTexture",W._indirectTexture,We),zt.setOptional(N,W,"batchingColorTexture"),W._colorsTexture!==null&&zt.setValue(N,"batchingColorTexture",W._colorsTexture,We));let Bn=j.morphAttributes;if((Bn.position!==void 0||Bn.normal!==void 0||Bn.color!==void 0)&&oe.update(W,j,Sn),(Pn||$e.receiveShadow!==W.receiveShadow)&&($e.receiveShadow=W.receiveShadow,zt.setValue(N,"receiveShadow",W.receiveShadow)),K.isMeshGouraudMaterial&&K.envMap!==null&&(In.envMap.value=Te,In.flipEnvMap.value=Te.isCubeTexture&&Te.isRenderTargetTexture===!1?-1:1),K.isMeshStandardMaterial&&K.envMap===null&&G.environment!==null&&(In.envMapIntensity.value=G.environmentIntensity),Pn&&(zt.setValue(N,"toneMappingExposure",x.toneMappingExposure),$e.needsLights&&_u(In,Gs),fe&&K.fog===!0&&ie.refreshFogUniforms(In,fe),ie.refreshMaterialUniforms(In,K,Z,Q,p.state.transmissionRenderTarget[E.id]),vo.upload(N,tl($e),In,We)),K.isShaderMaterial&&K.uniformsNeedUpdate===!0&&(vo.upload(N,tl($e),In,We),K.uniformsNeedUpdate=!1),K.isSpriteMaterial&&zt.setValue(N,"center",W.center),zt.setValue(N,"modelViewMatrix",W.modelViewMatrix),zt.setValue(N,"normalMatrix",W.normalMatrix),zt.setValue(N,"modelMatrix",W.matrixWorld),K.isShaderMaterial||K.isRawShaderMaterial){let dn=K.uniformsGroups;for(let fn=0,ps=dn.length;fn<ps;fn++){let ii=dn[fn];je.update(ii,Sn),je.bind(ii,Sn)}}return Sn}function _u(E,G){E.ambientLightColor.needsUpdate=G,E.lightProbe.needsUpdate=G,E.directionalLights.needsUpdate=G,E.directionalLightShadows.needsUpdate=G,E.pointLights.needsUpdate=G,E.pointLightShadows.needsUpdate=G,E.spotLights.needsUpdate=G,E.spotLightShadows.needsUpdate=G,E.rectAreaLights.needsUpdate=G,E.hemisphereLights.needsUpdate=G}function Vs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return A},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return F},this.setRenderTargetTextures=function(E,G,j){let K=Pe.get(E);K.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,K.__autoAllocateDepthBuffer===!1&&(K.__useRenderToTexture=!1),Pe.get(E.texture).__webglTexture=G,Pe.get(E.depthTexture).__webglTexture=K.__autoAllocateDepthBuffer?void 0:j,K.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,G){let j=Pe.get(E);j.__webglFramebuffer=G,j.__useDefaultFramebuffer=G===void 0};let il=N.createFramebuffer();this.setRenderTarget=function(E,G=0,j=0){F=E,A=G,D=j;let K=!0,W=null,fe=!1,Me=!1;if(E){let Te=Pe.get(E);if(Te.__useDefaultFramebuffer!==void 0)ke.bindFramebuffer(N.FRAMEBUFFER,null),K=!1;else if(Te.__webglFramebuffer===void 0)We.setupRenderTarget(E);else if(Te.__hasExternalTextures)We.rebindTextures(E,Pe.get(E.texture).__webglTexture,Pe.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Ve=E.depthTexture;if(Te.__boundDepthTexture!==Ve){if(Ve!==null&&Pe.has(Ve)&&(E.width!==Ve.image.width||E.height!==Ve.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");We.setupDepthRenderbuffer(E)}}let qe=E.texture;(qe.isData3DTexture||qe.isDataArrayTexture||qe.isCompressedArrayTexture)&&(Me=!0);let Ye=Pe.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ye[G])?W=Ye[G][j]:W=Ye[G],fe=!0):E.samples>0&&We.useMultisampledRTT(E)===!1?W=Pe.get(E).__webglMultisampledFramebuffer:Array.isArray(Ye)?W=Ye[j]:W=Ye,R.copy(E.viewport),B.copy(E.scissor),V=E.scissorTest}else R.copy(ye).multiplyScalar(Z).floor(),B.copy(we).multiplyScalar(Z).floor(),V=_e;if(j!==0&&(W=il),ke.bindFramebuffer(N.FRAMEBUFFER,W)&&K&&ke.drawBuffers(E,W),ke.viewport(R),ke.scissor(B),ke.setScissorTest(V),fe){let Te=Pe.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,j)}else if(Me){let Te=G;for(let qe=0;qe<E.textures.length;qe++){let Ye=Pe.get(E.textures[qe]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+qe,Ye.__webglTexture,j,Te)}}else if(E!==null&&j!==0){let Te=Pe.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Te.__webglTexture,j)}T=-1},this.readRenderTargetPixels=function(E,G,j,K,W,fe,Me,De=0){if(!(E&&E.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Te=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Me!==void 0&&(Te=Te[Me]),Te){ke.bindFramebuffer(N.FRAMEBUFFER,Te);try{let qe=E.textures[De],Ye=qe.format,Ve=qe.type;if(!Xe.textureFormatReadable(Ye)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Xe.textureTypeReadable(Ve)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=E.width-K&&j>=0&&j<=E.height-W&&(E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+De),N.readPixels(G,j,K,W,Oe.convert(Ye),Oe.convert(Ve),fe))}finally{let qe=F!==null?Pe.get(F).__webglFramebuffer:null;ke.bindFramebuffer(N.FRAMEBUFFER,qe)}}},this.readRenderTargetPixelsAsync=async function(E,G,j,K,W,fe,Me,De=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Te=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Me!==void 0&&(Te=Te[Me]),Te)if(G>=0&&G<=E.width-K&&j>=0&&j<=E.height-W){ke.bindFramebuffer(N.FRAMEBUFFER,Te);let qe=E.textures[De],Ye=qe.format,Ve=qe.type;if(!Xe.textureFormatReadable(Ye))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Xe.textureTypeReadable(Ve))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let at=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,at),N.bufferData(N.PIXEL_PACK_BUFFER,fe.byteLength,N.STREAM_READ),E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+De),N.readPixels(G,j,K,W,Oe.convert(Ye),Oe.convert(Ve),0);let xt=F!==null?Pe.get(F).__webglFramebuffer:null;ke.bindFramebuffer(N.FRAMEBUFFER,xt);let Ot=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await wg(N,Ot,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,at),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,fe),N.deleteBuffer(at),N.deleteSync(Ot),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,G=null,j=0){let K=Math.pow(2,-j),W=Math.floor(E.image.width*K),fe=Math.floor(E.image.height*K),Me=G!==null?G.x:0,De=G!==null?G.y:0;We.setTexture2D(E,0),N.copyTexSubImage2D(N.TEXTURE_2D,j,0,0,Me,De,W,fe),ke.unbindTexture()};let Li=N.createFramebuffer(),rn=N.createFramebuffer();this.copyTextureToTexture=function(E,G,j=null,K=null,W=0,fe=null){fe===null&&(W!==0?(so("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),fe=W,W=0):fe=0);let Me,De,Te,qe,Ye,Ve,at,xt,Ot,Rt=E.isCompressedTexture?E.mipmaps[fe]:E.image;if(j!==null)Me=j.max.x-j.min.x,De=j.max.y-j.min.y,Te=j.isBox3?j.max.z-j.min.z:1,qe=j.min.x,Ye=j.min.y,Ve=j.isBox3?j.min.z:0;else{let Bn=Math.pow(2,-W);Me=Math.floor(Rt.width*Bn),De=Math.floor(Rt.height*Bn),E.isDataArrayTexture?Te=Rt.depth:E.isData3DTexture?Te=Math.floor(Rt.depth*Bn):Te=1,qe=0,Ye=0,Ve=0}K!==null?(at=K.x,xt=K.y,Ot=K.z):(at=0,xt=0,Ot=0);let rt=Oe.convert(G.format),$e=Oe.convert(G.type),Bt;G.isData3DTexture?(We.setTexture3D(G,0),Bt=N.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(We.setTexture2DArray(G,0),Bt=N.TEXTURE_2D_ARRAY):(We.setTexture2D(G,0),Bt=N.TEXTURE_2D),N.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,G.flipY),N.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),N.pixelStorei(N.UNPACK_ALIGNMENT,G.unpackAlignment);let dt=N.getParameter(N.UNPACK_ROW_LENGTH),Sn=N.getParameter(N.UNPACK_IMAGE_HEIGHT),fs=N.getParameter(N.UNPACK_SKIP_PIXELS),Pn=N.getParameter(N.UNPACK_SKIP_ROWS),Gs=N.getParameter(N.UNPACK_SKIP_IMAGES);N.pixelStorei(N.UNPACK_ROW_LENGTH,Rt.width),N.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Rt.height),N.pixelStorei(N.UNPACK_SKIP_PIXELS,qe),N.pixelStorei(N.UNPACK_SKIP_ROWS,Ye),N.pixelStorei(N.UNPACK_SKIP_IMAGES,Ve);let zt=E.isDataArrayTexture||E.isData3DTexture,In=G.isDataArrayTexture||G.isData3DTexture;if(E.isDepthTexture){let Bn=Pe.get(E),dn=Pe.get(G),fn=Pe.get(Bn.__renderTarget),ps=Pe.get(dn.__renderTarget);ke.bindFramebuffer(N.READ_FRAMEBUFFER,fn.__webglFramebuffer),ke.bindFramebuffer(N.DRAW_FRAMEBUFFER,ps.__webglFramebuffer);for(let ii=0;ii<Te;ii++)zt&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Pe.get(E).__webglTexture,W,Ve+ii),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Pe.get(G).__webglTexture,fe,Ot+ii)),N.blitFramebuffer(qe,Ye,Me,De,at,xt,Me,De,N.DEPTH_BUFFER_BIT,N.NEAREST);ke.bindFramebuffer(N.READ_FRAMEBUFFER,null),ke.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(W!==0||E.isRenderTargetTexture||Pe.has(E)){let Bn=Pe.get(E),dn=Pe.get(G);ke.bindFramebuffer(N.READ_FRAMEBUFFER,Li),ke.bindFramebuffer(N.DRAW_FRAMEBUFFER,rn);for(let fn=0;fn<Te;fn++)zt?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Bn.__webglTexture,W,Ve+fn):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Bn.__webglTexture,W),In?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,dn.__webglTexture,fe,Ot+fn):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,dn.__webglTexture,fe),W!==0?N.blitFramebuffer(qe,Ye,Me,De,at,xt,Me,De,N.COLOR_BUFFER_BIT,N.NEAREST):In?N.copyTexSubImage3D(Bt,fe,at,xt,Ot+fn,qe,Ye,Me,De):N.copyTexSubImage2D(Bt,fe,at,xt,qe,Ye,Me,De);ke.bindFramebuffer(N.READ_FRAMEBUFFER,null),ke.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else In?E.isDataTexture||E.isData3DTexture?N.texSubImage3D(Bt,fe,at,xt,Ot,Me,De,Te,rt,$e,Rt.data):G.isCompressedArrayTexture?N.compressedTexSubImage3D(Bt,fe,at,xt,Ot,Me,De,Te,rt,Rt.data):N.texSubImage3D(Bt,fe,at,xt,Ot,Me,De,Te,rt,$e,Rt):E.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,fe,at,xt,Me,De,rt,$e,Rt.data):E.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,fe,at,xt,Rt.width,Rt.height,rt,Rt.data):N.texSubImage2D(N.TEXTURE_2D,fe,at,xt,Me,De,rt,$e,Rt);N.pixelStorei(N.UNPACK_ROW_LENGTH,dt),N.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Sn),N.pixelStorei(N.UNPACK_SKIP_PIXELS,fs),N.pixelStorei(N.UNPACK_SKIP_ROWS,Pn),N.pixelStorei(N.UNPACK_SKIP_IMAGES,Gs),fe===0&&G.generateMipmaps&&N.generateMipmap(Bt),ke.unbindTexture()},this.initRenderTarget=function(E){Pe.get(E).__webglFramebuffer===void 0&&We.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?We.setTextureCube(E,0):E.isData3DTexture?We.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?We.setTexture2DArray(E,0):We.setTexture2D(E,0),ke.unbindTexture()},this.resetState=function(){A=0,D=0,F=null,ke.reset(),ve.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}};var s0={type:"change"},hf={type:"start"},o0={type:"end"},gh=new Ps,r0=new li,XE=Math.cos(70*ka.DEG2RAD),cn=new U,zn=2*Math.PI,Lt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},cf=1e-6,_h=class extends Ra{constructor(e,t=null){super(e,t),this.state=Lt.NONE,this.target=new U,this.cursor=new U,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Si.ROTATE,MIDDLE:Si.DOLLY,RIGHT:Si.PAN},this.touches={ONE:Ei.ROTATE,TWO:Ei.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new U,this._lastQuaternion=new en,this._lastTargetPosition=new U,this._quat=new en().setFromUnitVectors(e.up,new U(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new fo,this._sphericalDelta=new fo,this._scale=1,this._panOffset=new U,this._rotateStart=new be,this._rotateEnd=new be,this._rotateDelta=new be,this._panStart=new be,this._panEnd=new be,this._panDelta=new be,this._dollyStart=new be,this._dollyEnd=new be,this._dollyDelta=new be,this._dollyDirection=new U,this._mouse=new be,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=qE.bind(this),this._onPointerDown=$E.bind(this),this._onPointerUp=YE.bind(this),this._onContextMenu=tT.bind(this),this._onMouseWheel=JE.bind(this),this._onKeyDown=jE.bind(this),this._onTouchStart=QE.bind(this),this._onTouchMove=eT.bind(this),this._onMouseDown=ZE.bind(this),this._onMouseMove=KE.bind(this),this._interceptControlDown=nT.bind(this),this._interceptControlUp=iT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(s0),this.update(),this.state=Lt.NONE}update(e=null){let t=this.object.position;cn.copy(t).sub(this.target),cn.applyQuaternion(this._quat),this._spherical.setFromVector3(cn),this.autoRotate&&this.state===Lt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=zn:n>Math.PI&&(n-=zn),s<-Math.PI?s+=zn:s>Math.PI&&(s-=zn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(cn.setFromSpherical(this._spherical),cn.applyQuaternion(this._quatInverse),t.copy(this.target).add(cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new U(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new U(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(gh.origin.copy(this.object.position),gh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(gh.direction))<XE?this.object.lookAt(this.target):(r0.setFromNormalAndCoplanarPoint(this.object.up,this.target),gh.intersectPlane(r0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>cf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>cf||this._lastTargetPosition.distanceToSquared(this.target)>cf?(this.dispatchEvent(s0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?zn/60*this.autoRotateSpeed*e:zn/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){cn.setFromMatrixColumn(t,0),cn.multiplyScalar(-e),this._panOffset.add(cn)}_panUp(e,t){this.screenSpacePanning===!0?cn.setFromMatrixColumn(t,1):(cn.setFromMatrixColumn(t,0),cn.crossVectors(this.object.up,cn)),cn.multiplyScalar(e),this._panOffset.add(cn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;cn.copy(s).sub(this.target);let r=cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-zn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(zn*this._rotateDelta.x/t.clientHeight),this._rotateUp(zn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new be,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function $E(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function qE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function YE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(o0),this.state=Lt.NONE;break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function ZE(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Si.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Lt.DOLLY;break;case Si.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}break;case Si.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Lt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Lt.PAN}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(hf)}function KE(i){switch(this.state){case Lt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Lt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Lt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function JE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Lt.NONE||(i.preventDefault(),this.dispatchEvent(hf),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(o0))}function jE(i){this.enabled!==!1&&this._handleKeyDown(i)}function QE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Ei.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Lt.TOUCH_ROTATE;break;case Ei.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Lt.TOUCH_PAN;break;default:this.state=Lt.NONE}break;case 2:switch(this.touches.TWO){case Ei.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Lt.TOUCH_DOLLY_PAN;break;case Ei.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Lt.TOUCH_DOLLY_ROTATE;break;default:this.state=Lt.NONE}break;default:this.state=Lt.NONE}this.state!==Lt.NONE&&this.dispatchEvent(hf)}function eT(i){switch(this._trackPointer(i),this.state){case Lt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Lt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Lt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Lt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Lt.NONE}}function tT(i){this.enabled!==!1&&i.preventDefault()}function nT(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function iT(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function a0(i){let e=[...i].sort((s,r)=>s[0]-r[0]||s[1]-r[1]),t=(s,r,o)=>(r[0]-s[0])*(o[1]-s[1])-(r[1]-s[1])*(o[0]-s[0])>1e-12,n=s=>{let r=[];for(let o of s){for(;r.length>=2&&!t(r[r.length-2],r[r.length-1],o);)r.pop();r.push(o)}return r.slice(0,-1)};return e.length<3?e:[...n(e),...n(e.reverse())]}var sT=24,rT=.005,Ua={made:.001,support:.002,planned:.003,marks:.004};function uf(i,e){let t=new Vt;t.setAttribute("position",new on(new Float32Array(3*i),3));let n=new ca(t,new Vi({color:e}));return n.frustumCulled=!1,n.visible=!1,n}function df(i,e,t){let n=i.geometry.getAttribute("position");for(let[s,[r,o]]of e.entries())n.setXYZ(s,r,o,t);n.needsUpdate=!0,i.geometry.setDrawRange(0,e.length),i.visible=e.length>2}function ff(i,e){let t=new mt(new da(i,24),new An({color:e,depthTest:!1}));return t.renderOrder=2,t.visible=!1,t}var yh=class{constructor(e,t,n){this.sole=e;this.size_m=t;this.colours=n;this.grid=this.makeGrid(),this.support=new mt(new Vt,new An({color:n.support,transparent:!0,opacity:.3,depthTest:!1})),this.support.renderOrder=1,this.support.frustumCulled=!1,this.supportEdge=uf(8,n.support),this.planned=Array.from({length:4},()=>uf(4,n.planned));let s=t*.028;this.zmp=ff(s,n.zmp),this.plannedZmp=ff(s*.6,n.plannedZmp),this.com=ff(s*.8,n.com),this.comDrop=new or(new Vt().setFromPoints([new U,new U(0,0,1)]),new Vi({color:n.com})),this.comDrop.visible=!1,this.group.add(this.grid,this.support,this.supportEdge,...this.planned,this.zmp,this.plannedZmp,this.com,this.comDrop)}group=new Nt;grid;support;supportEdge;planned;made=[];zmp;plannedZmp;com;comDrop;gridShown=!0;stood=[!1,!1];setColours(e){this.colours=e,this.group.remove(this.grid),this.grid.dispose(),this.grid=this.makeGrid(),this.group.add(this.grid);let t=(n,s)=>n.material.color.setHex(s);for(let n of this.made)t(n,e.made);for(let n of this.planned)t(n,e.planned);for(let n of[this.support,this.supportEdge])t(n,e.support);t(this.zmp,e.zmp),t(this.plannedZmp,e.plannedZmp);for(let n of[this.com,this.comDrop])t(n,e.com)}hideGrid(){this.gridShown=!1,this.grid.visible=!1}forgetSteps(){this.group.remove(...this.made);for(let{geometry:e}of this.made.splice(0))e.dispose()}show(e,t){let[n=NaN,s=NaN]=e.base_place;if(Number.isNaN(n))return;this.grid.position.set(Math.round(n),Math.round(s),0),this.showSteps(e,n,s),this.showSupport(e,t);let r=(o,a)=>{let[l=NaN,c=NaN]=a;o.visible=!Number.isNaN(l+c),o.visible&&o.position.set(n+l,s+c,Ua.marks)};r(this.zmp,e.zmp),r(this.plannedZmp,e.planned_zmp),r(this.com,e.com),this.comDrop.visible=this.com.visible&&!Number.isNaN(e.com[2]??NaN),this.comDrop.visible&&(this.comDrop.position.copy(this.com.position),this.comDrop.scale.z=e.com[2]??0)}showSteps(e,t,n){let s=e.footstep_count[0]??0;for(let[r,o]of this.planned.entries()){let[a=0,l=0,c=0]=e.footstep.slice(3*r,3*r+3);o.visible=r<s,o.visible&&df(o,this.rectangle(t+a,n+l,c),Ua.planned)}}showSupport(e,t){let n=[];for(let r of[0,1]){let o=e.contact[r]===1,a=o?t.soleCorners(r):[],l=a.map(({x:c,y:h})=>[c,h]);n.push(...l),o&&!this.stood[r]&&this.addMade(l,Math.max(...a.map(({z:c})=>c))),this.stood[r]=o}let s=a0(n);df(this.supportEdge,s,Ua.support),this.support.visible=s.length>2,this.support.visible&&(this.support.geometry.dispose(),this.support.geometry=new Is(new as(s.map(([r,o])=>new be(r,o)))),this.support.position.z=Ua.support)}addMade(e,t){let n=this.made.length<sT?uf(4,this.colours.made):this.made.shift();n&&(this.made.push(n),this.group.add(n),df(n,e,Ua.made+(t>rT?t:0)))}rectangle(e,t,n){let{length:s,width:r,ahead:o}=this.sole,[a,l]=[Math.cos(n),Math.sin(n)];return[[o+s/2,r/2],[o-s/2,r/2],[o-s/2,-r/2],[o+s/2,-r/2]].map(([h,u])=>[e+a*h-l*u,t+l*h+a*u])}makeGrid(){let e=2*Math.ceil(this.size_m*5),t=new pr(e,e*4,this.colours.grid,this.colours.grid);return t.rotation.x=Math.PI/2,t.visible=this.gridShown,t}};var xh=class{last_ms=-1/0;drawn_ms=[];windowBegan_ms=-1/0;wished=0;drawn=0;goodWindows=0;fineness=1;total=0;isDue(e){return e-this.last_ms>=30}wish(){this.wished+=1}drew(e){for(this.last_ms=e,this.drawn_ms.push(e);(this.drawn_ms[0]??e)<e-1e3;)this.drawn_ms.shift();if(this.drawn+=1,this.total+=1,e-this.windowBegan_ms<2e3)return!1;let n=this.windowBegan_ms>-1/0&&e-this.windowBegan_ms<2*2e3&&this.judge(this.drawn/Math.max(this.wished,1),this.wished*1e3/(e-this.windowBegan_ms));return this.windowBegan_ms=e,this.wished=this.drawn=0,n}get perSecond(){return this.drawn_ms.length}judge(e,t){let n=this.fineness;return this.goodWindows=e>.9?this.goodWindows+1:0,e<.75&&t>20&&(this.fineness=Math.max(this.fineness*.8,.5)),this.goodWindows>=10&&(this.goodWindows=0,this.fineness=Math.min(this.fineness/.8,1)),this.fineness!==n}};var vh=class{constructor(e,t){this.size_m=e;this.most_N=t;let n=e*.012;this.shaft=new mt(new Gi(n,n,1,12).translate(0,.5,0).rotateX(Math.PI/2),this.material),this.head=new mt(new fa(n*3,n*8,16).rotateX(Math.PI/2),this.material),this.shaft.renderOrder=this.head.renderOrder=3,this.group.add(this.shaft,this.head),this.group.visible=!1}group=new Nt;shaft;head;material=new An({depthTest:!1,depthWrite:!1,transparent:!0,opacity:.9});grip;set colour(e){this.material.color.setHex(e)}show(e,[t,n]){let s=Math.hypot(t,n),r=this.size_m*(.12+.88*s/this.most_N);this.shaft.scale.z=r,this.head.position.z=r,this.group.quaternion.setFromUnitVectors(new U(0,0,1),new U(t,n,0).normalize()),this.group.visible=!0,this.grip=e,this.follow()}hide(){this.group.visible=!1,this.grip=void 0}follow(){this.grip&&(this.grip.group.updateWorldMatrix(!0,!1),this.group.position.copy(this.grip.place).applyMatrix4(this.grip.group.matrixWorld))}};var bh=class extends ur{constructor(e){super(e)}load(e,t,n,s){let r=this,o=new Sa(this.manager);o.setPath(this.path),o.setResponseType("arraybuffer"),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(r.parse(a))}catch(l){s?s(l):console.error(l),r.manager.itemError(e)}},n,s)}parse(e){function t(c){let h=new DataView(c),u=32/8*3+32/8*3*3+16/8,d=h.getUint32(80,!0);if(80+32/8+d*u===h.byteLength)return!0;let g=[115,111,108,105,100];for(let y=0;y<5;y++)if(n(g,h,y))return!1;return!0}function n(c,h,u){for(let d=0,f=c.length;d<f;d++)if(c[d]!==h.getUint8(u+d))return!1;return!0}function s(c){let h=new DataView(c),u=h.getUint32(80,!0),d,f,g,y=!1,m,p,b,w,x;for(let R=0;R<70;R++)h.getUint32(R,!1)==1129270351&&h.getUint8(R+4)==82&&h.getUint8(R+5)==61&&(y=!0,m=new Float32Array(u*3*3),p=h.getUint8(R+6)/255,b=h.getUint8(R+7)/255,w=h.getUint8(R+8)/255,x=h.getUint8(R+9)/255);let P=84,A=50,D=new Vt,F=new Float32Array(u*3*3),T=new Float32Array(u*3*3),S=new Ze;for(let R=0;R<u;R++){let B=P+R*A,V=h.getFloat32(B,!0),X=h.getFloat32(B+4,!0),$=h.getFloat32(B+8,!0);if(y){let q=h.getUint16(B+48,!0);(q&32768)===0?(d=(q&31)/31,f=(q>>5&31)/31,g=(q>>10&31)/31):(d=p,f=b,g=w)}for(let q=1;q<=3;q++){let Q=B+q*12,Z=R*3*3+(q-1)*3;F[Z]=h.getFloat32(Q,!0),F[Z+1]=h.getFloat32(Q+4,!0),F[Z+2]=h.getFloat32(Q+8,!0),T[Z]=V,T[Z+1]=X,T[Z+2]=$,y&&(S.setRGB(d,f,g,Ht),m[Z]=S.r,m[Z+1]=S.g,m[Z+2]=S.b)}}return D.setAttribute("position",new on(F,3)),D.setAttribute("normal",new on(T,3)),y&&(D.setAttribute("color",new on(m,3)),D.hasColors=!0,D.alpha=x),D}function r(c){let h=new Vt,u=/solid([\s\S]*?)endsolid/g,d=/facet([\s\S]*?)endfacet/g,f=/solid\s(.+)/,g=0,y=/[\s]+([+-]?(?:\d*)(?:\.\d*)?(?:[eE][+-]?\d+)?)/.source,m=new RegExp("vertex"+y+y+y,"g"),p=new RegExp("normal"+y+y+y,"g"),b=[],w=[],x=[],P=new U,A,D=0,F=0,T=0;for(;(A=u.exec(c))!==null;){F=T;let S=A[0],R=(A=f.exec(S))!==null?A[1]:"";for(x.push(R);(A=d.exec(S))!==null;){let X=0,$=0,q=A[0];for(;(A=p.exec(q))!==null;)P.x=parseFloat(A[1]),P.y=parseFloat(A[2]),P.z=parseFloat(A[3]),$++;for(;(A=m.exec(q))!==null;)b.push(parseFloat(A[1]),parseFloat(A[2]),parseFloat(A[3])),w.push(P.x,P.y,P.z),X++,T++;$!==1&&console.error("THREE.STLLoader: Something isn't right with the normal of face number "+g),X!==3&&console.error("THREE.STLLoader: Something isn't right with the vertices of face number "+g),g++}let B=F,V=T-F;h.userData.groupNames=x,h.addGroup(B,V,D),D++}return h.setAttribute("position",new ut(b,3)),h.setAttribute("normal",new ut(w,3)),h}function o(c){return typeof c!="string"?new TextDecoder().decode(c):c}function a(c){if(typeof c=="string"){let h=new Uint8Array(c.length);for(let u=0;u<c.length;u++)h[u]=c.charCodeAt(u)&255;return h.buffer||h}else return c}let l=a(e);return t(l)?s(l):r(o(e))}};function l0(i,{place:e,turn:t}){i.position.fromArray(e),i.quaternion.fromArray(t)}function oT({kind:i,size:e}){return i==="sphere"?new Ls(e[0]/2,20,14):i==="cylinder"?new Gi(e[0]/2,e[0]/2,e[2],24).rotateX(Math.PI/2):new Hi(...e)}async function aT(i,e){let t=await fetch(i.mesh?.slice(1)??"",Ji(e));if(!t.ok)throw new Error(await t.text());let n=new bh().parse(await t.arrayBuffer()),s=i.scale??[1,1,1],r=i.centre??[0,0,0];return n.scale(...s).translate(-r[0],-r[1],-r[2]),n.computeVertexNormals(),n}var Us=class{constructor(e){this.description=e;this.links=e.links.map(()=>new Nt),this.base.add(this.links[0]??new Nt);for(let t of e.joints){let n=this.links[t.child];n&&(l0(n,t),this.links[t.parent]?.add(n),this.turning.push({group:n,rest:n.quaternion.clone(),axis:new U(...t.axis)}))}this.pose(e.joints.map(({home:t})=>t));for(let[t,{shapes:n}]of e.links.entries())for(let s of n)this.links[t]?.add(this.solid(s,oT(s)))}base=new Nt;links;turning=[];materials=new Map;spin=new en;async loadMeshes(e,t){let n=[];for(let[s,{shapes:r}]of this.description.links.entries())for(let[o,a]of r.entries()){let l=this.links[s]?.children.filter(c=>c instanceof mt)[o];!(l instanceof mt)||a.mesh===void 0||n.push(aT(a,e).then(c=>{l.geometry.dispose(),l.geometry=c,t()}))}await Promise.all(n)}pose(e){for(let[t,{group:n,rest:s,axis:r}]of this.turning.entries()){let o=e[t];o===void 0||Number.isNaN(o)||n.quaternion.copy(s).multiply(this.spin.setFromAxisAngle(r,o))}}gripAt(e){this.base.updateWorldMatrix(!1,!0);for(let{object:t,point:n}of e.intersectObject(this.base,!0)){let s=this.links.findIndex(o=>o===t.parent),r=this.links[s];if(r)return{link:s,group:r,place:r.worldToLocal(n.clone())}}}gripOn(e){let t=this.links[e],n=t?.children.find(s=>s instanceof mt);return t&&{link:e,group:t,place:n?.position.clone()??new U}}solePose(e){let{link:t,place:n,turn:s}=this.description.soles[e],r=new Et().compose(new U(...n),new en(...s),new U(1,1,1)),o=this.links[t];return o?(o.updateWorldMatrix(!0,!1),r.premultiply(o.matrixWorld)):r}soleCorners(e){let{size:t,centre:n}=this.description.soles[e],s=this.solePose(e);return[[1,1],[-1,1],[-1,-1],[1,-1]].map(([o,a])=>new U(n[0]+o*t[0]/2,n[1]+a*t[1]/2,0).applyMatrix4(s))}setOld(e){for(let t of this.materials.values())t.transparent=e,t.opacity=e?.35:1,t.needsUpdate=!0}solid(e,t){let n=e.rgba.join(),s=this.materials.get(n);if(!s){let[o,a,l]=e.rgba;s=new cr({color:new Ze().setRGB(o,a,l,Ht)}),this.materials.set(n,s)}let r=new mt(t,s);return l0(r,e),r}};var c0={light:{sky:15265266,ground:14541801,grid:12831958,made:9082790,planned:1533634,support:1804875,zmp:13708332,plannedZmp:1533634,com:11561472,push:8006614,way:{left:888719,right:13920538,goal:1533634}},dark:{sky:1185565,ground:1514788,grid:2765629,made:6122362,planned:6533375,support:3523194,zmp:16739166,plannedZmp:6533375,com:16758605,push:12819455,way:{left:3131072,right:16751181,goal:6533375}}};function lT(){return document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0})===null}function cT(i,e){let t=i.getContext("webgl2",{alpha:!1,antialias:e,stencil:!1,powerPreference:"low-power"});if(!t)throw new Error("this browser draws no WebGL 2");return t}var wh=class{constructor(e,t){this.canvas=e;this.size_m=t.hip_height*2,this.software=lT(),this.renderer=new bo({canvas:e,context:cT(e,!this.software)}),this.body=new Us(t);let[n]=t.soles;this.ground=new yh({length:n.size[0],width:n.size[1],ahead:n.centre[0]},this.size_m,c0.light),this.arrow=new vh(this.size_m,t.bounds.push?.most??1),this.scene.fog=this.fog,this.scene.add(this.body.base,this.ground.group,this.arrow.group,new dr(16777215,8952234,2));let s=new fr(16777215,2.2);s.position.set(1.5,2,4),this.scene.add(s),this.camera.up.set(0,0,1),this.controls=new _h(this.camera,e),this.controls.maxPolarAngle=Math.PI*.53,this.controls.minDistance=this.size_m*.6,this.controls.maxDistance=this.size_m*20,this.controls.addEventListener("change",()=>this.ask()),this.body.base.position.z=t.hip_height,this.followed.set(0,0,this.size_m*.56),this.lookFrom("behind"),new ResizeObserver(()=>this.resize()).observe(e);let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>this.paint(r.matches)),this.paint(r.matches)}body;pace=new xh;software;renderer;scene=new rr;fog=new la(0);camera=new xn(38,1,.02,200);controls;ground;arrow;size_m;followed=new U;pending=!0;old=!1;asked=!1;dark=!1;hazeAfter=6.5;follows=!0;onDrawn=()=>{};onBeforeDraw=()=>{};onPaint=()=>{};show(e){let[t=NaN,n=NaN]=e.base_place,s=e.base_height[0]??NaN;if(!Number.isNaN(t+n+s)){this.body.base.position.set(t,n,s);let[r=0,o=0,a=0,l=1]=e.base_turn;this.body.base.quaternion.set(r,o,a,l).normalize()}this.body.pose(e.joint),this.ground.show(e,this.body),this.arrow.follow(),this.follows&&this.follow(),this.pace.wish(),this.ask()}setOld(e){e!==this.old&&(this.old=e,this.body.setOld(e),this.ask())}lookFrom(e){let t=this.size_m*2.5,n={behind:[-.78*t,-.52*t,.42*t],front:[t,.15*t,.25*t],side:[0,-t,.2*t],top:[-.02*t,0,1.2*t]};this.controls.target.copy(this.followed),this.camera.position.copy(this.followed).add(new U(...n[e])),this.controls.update(),this.ask()}zoom(e){let t=this.camera.position.clone().sub(this.controls.target);t.setLength(ka.clamp(t.length()*e,this.controls.minDistance,this.controls.maxDistance)),this.camera.position.copy(this.controls.target).add(t),this.controls.update(),this.ask()}gripAt(e,t){return this.body.gripAt(this.rayAt(e,t))}rayAt(e,t){let{left:n,top:s,width:r,height:o}=this.canvas.getBoundingClientRect(),a=new Aa;return a.setFromCamera(new be(2*(e-n)/r-1,1-2*(t-s)/o),this.camera),a}add(e){this.scene.add(e),this.ask()}showWorld(){this.ground.hideGrid(),this.ask()}forgetSteps(){this.ground.forgetSteps(),this.ask()}turnBySecond(e){this.controls.mouseButtons.RIGHT=e?Si.ROTATE:Si.PAN,this.controls.touches.TWO=e?Ei.DOLLY_ROTATE:Ei.DOLLY_PAN}repaint(){this.paint(this.dark)}gripOn(e){return this.body.gripOn(e)}away(){let e=this.camera.getWorldDirection(new U);Math.hypot(e.x,e.y)<.2&&e.set(0,1,0).applyQuaternion(this.camera.quaternion);let t=Math.hypot(e.x,e.y);return[e.x/t,e.y/t]}showPush(e,t){this.arrow.show(e,t),this.ask()}hidePush(){this.arrow.hide(),this.ask()}ask(){this.pending=!0,!(this.asked||document.hidden)&&(this.asked=!0,requestAnimationFrame(e=>this.draw(e)))}draw(e){if(this.asked=!1,!!this.pending){if(!this.pace.isDue(e)){this.ask();return}this.pending=!1,this.haze(),this.onBeforeDraw(e,this.camera,this.fog.far),this.renderer.render(this.scene,this.camera),this.pace.drew(e)&&this.resize(),this.onDrawn()}}haze(){let e=this.camera.position.distanceTo(this.controls.target);this.fog.near=e+this.size_m,this.fog.far=e+Math.max(this.hazeAfter*this.size_m,e)}follow(){let{x:e,y:t}=this.body.base.position,n=new U(e-this.followed.x,t-this.followed.y,0);this.followed.add(n),this.controls.target.add(n),this.camera.position.add(n),this.camera.updateMatrixWorld()}paint(e){this.dark=e;let t=c0[e?"dark":"light"];this.scene.background=new Ze(t.sky),this.fog.color.set(t.sky),this.ground.setColours(t),this.arrow.colour=t.push,this.onPaint(t,e),this.ask()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.renderer.setPixelRatio(Math.min(devicePixelRatio,this.software?1:2)*this.pace.fineness),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.ask())}};var pf={name:"/simulation/state",type:"gaitway_msgs/msg/SimulationState"},mf=1e3,hT=["command","push","fault","world","fall"],h0=["playing","paused","busy","failed"],Oa=i=>Array.isArray(i)?i:[],Mh=i=>Oa(i).map(Number);function gf(i){let{position:e,orientation:t}=i;return{place:[e.x,e.y,e.z],turn:[t.x,t.y,t.z,t.w]}}function u0(i){let e=Oa(i.mark_kinds),t=Oa(i.event_texts),n=Oa(i.thing_poses),s=Mh(i.odometry),r=Mh(i.base),o=String(i.state);return{time_s:Number(i.time),recorded_s:Math.max(Number(i.recorded),Number(i.time)),state:h0.includes(o)?o:"failed",text:h0.includes(o)?String(i.text??""):`it says that it is '${o}', which this page does not know`,speed:Number(i.speed),pace:Number(i.pace),world:String(i.world??""),geometry:Number(i.geometry),run:Number(i.run),fallen:i.fallen===!0,odometry:s.length===4&&s.every(Number.isFinite)?{x:s[0],y:s[1],z:s[2],yaw:s[3]}:void 0,base:r.length===7?{place:r.slice(0,3),turn:r.slice(3)}:void 0,things:new Map(Oa(i.thing_names).flatMap((a,l)=>n[l]?[[String(a),gf(n[l])]]:[])),marks:Mh(i.mark_times).flatMap((a,l)=>hT.includes(String(e[l]))?[{at_s:a,kind:e[l]}]:[]),events:Mh(i.event_times).map((a,l)=>({at_s:a,text:String(t[l]??"")}))}}function d0({state:i,speed:e}){return i==="playing"?e:0}var f0=i=>[Number(i[0]),Number(i[1]),Number(i[2])];function y0(i){let e=i.solids.map(t=>{let n=t.size,s=String(t.shape);if(s!=="box"&&s!=="cylinder"&&s!=="sphere")throw new Error(`solid '${String(t.name)}' has the shape '${s}': box, cylinder or sphere is known`);return{...gf(t.pose),name:String(t.name),kind:String(t.kind),shape:s,size:[n.x,n.y,n.z],colour:f0(t.colour),movable:t.movable===!0}});return{geometry:Number(i.geometry),world:String(i.world),total:Number(i.total),floorColour:f0(i.floor_colour),solids:e}}function Ba({kind:i}){return i==="step"||i==="slope"||i==="tile"}function p0([i,e,t,n],[s,r,o]){let[a,l,c]=[2*(t*r-e*o),2*(i*o-t*s),2*(e*s-i*r)];return[s+n*a-(e*c-t*l),r+n*l-(t*a-i*c),o+n*c-(i*l-e*a)]}function m0([i,e,t],n,s){let[r,o]=[-1/0,1/0];for(let[a,l]of[i,e,t].entries()){let c=s[a]/2,h=n[a];if(Math.abs(h)<1e-12){if(Math.abs(l)>c)return;continue}let[u,d]=[(-c-l)/h,(c-l)/h];r=Math.max(r,Math.min(u,d)),o=Math.min(o,Math.max(u,d))}return r<=o&&o>=0?Math.max(r,0):void 0}function g0(i,e,t){let n=e.reduce((a,l)=>a+l*l,0),s=e.reduce((a,l,c)=>a+l*i[c],0),r=i.reduce((a,l)=>a+l*l,-t*t);if(n<1e-12)return r<=0?[-1/0,1/0]:void 0;let o=s*s-n*r;return o<0?void 0:[(-s-Math.sqrt(o))/n,(-s+Math.sqrt(o))/n]}function x0(i,{origin:e,direction:t},n=i){let{place:s}=n,r=p0(n.turn,[e[0]-s[0],e[1]-s[1],e[2]-s[2]]),o=p0(n.turn,t);if(i.shape==="box")return m0(r,o,i.size);let a=i.shape==="sphere"?g0(r,o,i.size[0]/2):g0(r.slice(0,2),o.slice(0,2),i.size[0]/2);if(!a)return;let[l,c]=a;if(i.shape==="cylinder"){if(m0([0,0,r[2]],[0,0,o[2]],[1,1,i.size[2]])===void 0)return;if(Math.abs(o[2])>1e-12){let u=i.size[2]/2,d=[(-u-r[2])/o[2],(u-r[2])/o[2]];l=Math.max(l,Math.min(...d)),c=Math.min(c,Math.max(...d))}}return l<=c&&c>=0?Math.max(l,0):void 0}var uT=({origin:i,direction:e},t)=>[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]];function v0(i,e,t=n=>n){let n,s=(r,o)=>{r===void 0||r>=(n?.distance_m??1/0)||(n={distance_m:r,place:uT(i,r),solid:o})};i.direction[2]<-1e-6&&i.origin[2]>0&&s(-i.origin[2]/i.direction[2],void 0);for(let r of e)s(x0(r,i,t(r)),r);return n}var _0=50;function b0(i,e,t){let n=0;for(let s of i){if(!Ba(s))continue;let r=x0(s,{origin:[e,t,_0],direction:[0,0,-1]});r!==void 0&&(n=Math.max(n,_0-r))}return n}var za=i=>Math.atan2(Math.sin(i),Math.cos(i));function w0({x:i,y:e,z:t,yaw:n}){let[s,r]=[Math.cos(n),Math.sin(n)];return{x:-(s*i+r*e),y:-(s*e-r*i),z:-t,yaw:-n}}function _f({x:i,y:e,z:t,yaw:n},s){let[r,o]=[Math.cos(n),Math.sin(n)];return{x:i+r*s.x-o*s.y,y:e+o*s.x+r*s.y,z:t+s.z}}var Sh=class{wanted;shown;run;get isKnown(){return this.shown!==void 0}take(e,t){if(!e)return!1;let{shown:n}=this,s=!n||t!==this.run||Math.hypot(e.x-n.x,e.y-n.y,e.z-n.z)>.25||Math.abs(za(e.yaw-n.yaw))>.35;return this.wanted=e,this.run=t,s&&(this.shown={...e}),s}after(e){let{wanted:t,shown:n}=this;if(!t||!n)return;let s=1-Math.exp(-Math.max(e,0)/.25);return n.x+=s*(t.x-n.x),n.y+=s*(t.y-n.y),n.z+=s*(t.z-n.z),n.yaw+=s*za(t.yaw-n.yaw),n}};var M0=.006,dT=.28;function fT(i,e,t){let[n,s,r]=[i/2,e/2,dT*e],o=new as().moveTo(-n+r,-s).lineTo(n-r,-s).quadraticCurveTo(n,-s,n,-s+r).lineTo(n,s-r).quadraticCurveTo(n,s,n-r,s).lineTo(-n+r,s).quadraticCurveTo(-n,s,-n,s-r).lineTo(-n,-s+r).quadraticCurveTo(-n,-s,-n+r,-s);return new Is(o,4).translate(t,0,0)}function Ha(i,e){return new An({color:i,transparent:!0,opacity:e,depthWrite:!1,side:hi,polygonOffset:!0,polygonOffsetFactor:-2,polygonOffsetUnits:-4})}var Eh=class{group=new Nt;sole;coming;passed;goalMaterial;goal=new Nt;soles=[];sides=[];constructor(e,t,n){this.sole=fT(e.length,e.width,e.ahead),this.coming=[Ha(n.left,.85),Ha(n.right,.85)],this.passed=[Ha(n.left,.16),Ha(n.right,.16)],this.goalMaterial=Ha(n.goal,.9);let s=t*.24,r=new mt(new wa(s*.86,s,48),this.goalMaterial),o=new as().moveTo(s*1.75,0).lineTo(s*1.12,s*.42).lineTo(s*1.12,-s*.42);this.goal.add(r,new mt(new Is(o),this.goalMaterial)),this.goal.visible=!1,this.group.add(this.goal)}setColours({left:e,right:t,goal:n}){for(let s of[this.coming,this.passed])s[0].color.setHex(e),s[1].color.setHex(t);this.goalMaterial.color.setHex(n)}showGoal({x:e,y:t,yaw:n},s){this.goal.position.set(e,t,s(e,t)+M0),this.goal.rotation.z=n,this.goal.visible=!0}showPlan(e,t){this.clearSteps(),this.sides=e.steps.map(({side:n})=>n);for(let{x:n,y:s,yaw:r,side:o}of e.steps){let a=new mt(this.sole,this.coming[o]);a.position.set(n,s,t(n,s)+M0),a.rotation.z=r,this.soles.push(a),this.group.add(a)}}fade(e){for(let[t,n]of this.soles.entries())n.material=(t<e?this.passed:this.coming)[this.sides[t]??0]}clearSteps(){for(let e of this.soles.splice(0))this.group.remove(e)}clear(){this.clearSteps(),this.goal.visible=!1}};var pT=8368874;function yf(i,e=1){i.base.traverse(t=>{if(!(t instanceof mt))return;let n=t.material;n.color.set(pT),n.transparent=e<1,n.opacity=e,n.depthWrite=e===1})}var Th=class{group=new Nt;body;constructor(e){this.body=new Us(e),yf(this.body,.42),this.body.base.updateMatrixWorld(!0);let t=[0,1].map(s=>new U().setFromMatrixPosition(this.body.solePose(s))),n=t[0].add(t[1]).multiplyScalar(.5);this.body.base.position.sub(n),this.group.add(this.body.base),this.group.visible=!1}show(e,t,n,s){this.group.position.set(e,t,n),this.group.rotation.z=s,this.group.visible=!0}hide(){this.group.visible=!1}};var mT={box:()=>new Hi(1,1,1),cylinder:i=>new Gi(.5,.5,1,i?24:8).rotateX(Math.PI/2),sphere:i=>i?new Ls(.5,20,14):new Ls(.5,8,5)},S0=new Map;function Ah(i,e){let t=`${i} ${e}`,n=S0.get(t)??mT[i](e);return S0.set(t,n),n}var E0=3,gT=300,_T=new U(1.5,2,4).normalize(),yT=2.2,xT=2,xf=new Ze(8952234);function vT(i,e){let t=.5+.5*i.z,n=yT*Math.max(i.dot(_T),0),s=r=>(n+xT*(r+(1-r)*t))/Math.PI;return e.setRGB(s(xf.r),s(xf.g),s(xf.b))}var vf=class{positions=[];colours=[];indices=[];matrix=new Et;turn=new en;point=new U;lit=new Ze;paint=new Ze;add(e,t){let n=Ah(e.shape,t),[s,r]=[n.getAttribute("position"),n.getAttribute("normal")],o=this.positions.length/3,a=new U(...e.size);this.matrix.compose(this.point.fromArray(e.place),this.turn.fromArray(e.turn),a),this.paint.setRGB(...e.colour,Ht);for(let l=0;l<s.count;++l){this.point.fromBufferAttribute(s,l).applyMatrix4(this.matrix),this.positions.push(this.point.x,this.point.y,this.point.z);let{r:c,g:h,b:u}=vT(this.point.fromBufferAttribute(r,l).divide(a).normalize().applyQuaternion(this.turn),this.lit).multiply(this.paint);this.colours.push(c,h,u)}for(let l of n.index?.array??[])this.indices.push(o+l)}mesh(e){let t=new Vt;return t.setAttribute("position",new ut(this.positions,3)),t.setAttribute("color",new ut(this.colours,3)),t.setIndex(this.indices),t.computeBoundingSphere(),new mt(t,e)}},Rh=class{group=new Nt;material=new An({vertexColors:!0});set brightness(e){this.material.color.setScalar(e)}show(e){for(let n of this.group.children.splice(0))n.geometry.dispose();let t=new Map;for(let n of e){let s=`${Math.floor(n.place[0]/E0)} ${Math.floor(n.place[1]/E0)}`,r=t.get(s)??new vf;t.set(s,r),r.add(n,e.length<=gT)}for(let n of t.values())this.group.add(n.mesh(this.material))}see(e,t){for(let n of this.group.children){let s=n.geometry.boundingSphere;n.visible=!s||e.distanceTo(s.center)-s.radius<t}}};var bT=.08,wT=1e-4,MT=1e-7,Ch=class{group=new Nt;things=new Map;held;brightness=1;show(e){let t=new Map([...this.things].map(([n])=>[n,this.poseOf(n)]));for(let{mesh:n}of this.things.values())n.material.dispose();this.things.clear(),this.group.clear();for(let n of e)this.add(n,t.get(n.name)??n);this.held&&this.group.add(this.held.mesh)}setBrightness(e){this.brightness=e;for(let{mesh:t,solid:n}of this.things.values())this.paint(t,n)}poseOf(e){let t=this.held?.solid.name===e?this.held:this.things.get(e);return t&&{place:t.mesh.position.toArray(),turn:t.mesh.quaternion.toArray()}}move(e,t){for(let[n,s]of e){let r=this.things.get(n);!r||r===this.held||(r.wanted=s,t&&this.follow(r,s,1))}}after(e){let t=1-Math.exp(-e/bT);for(let n of this.things.values())n.wanted&&n!==this.held&&this.follow(n,n.wanted,t)}hold(e,{place:t,turn:n}){this.held??=this.things.get(e.name)??this.make(e,e),this.held.mesh.position.set(...t),this.held.mesh.quaternion.set(...n),this.held.mesh.parent||this.group.add(this.held.mesh)}letGo(){let{held:e}=this;this.held=void 0,e&&this.things.get(e.solid.name)!==e&&this.group.remove(e.mesh)}add(e,t){let n=this.make(e,t);this.things.set(e.name,n),this.group.add(n.mesh)}make(e,{place:t,turn:n}){let s=new mt(Ah(e.shape,!0),new cr);return this.paint(s,e),s.scale.set(...e.size),s.position.set(...t),s.quaternion.set(...n),{mesh:s,solid:e,wanted:void 0}}paint(e,{colour:t}){e.material.color.setRGB(...t,Ht).multiplyScalar(this.brightness)}follow(e,{place:t,turn:n},s){let{position:r,quaternion:o}=e.mesh,[a,l]=[new U(...t),new en(...n)];r.lerp(a,s),o.slerp(l,s),!(r.distanceTo(a)>wT||Math.abs(o.dot(l))<1-MT)&&(r.copy(a),o.copy(l),e.wanted=void 0)}};var T0=40,ST={half_m:8,every_m:.5,piece_m:2},A0=.72,Ph=class{group=new Nt;things=new Ch;fixed=new Rh;floorMaterial=new An({depthWrite:!1});lineMaterial=new Vi({depthWrite:!1});ground=new Nt;floorColour=new Ze(.75,.75,.75);dark=!1;all=[];constructor(){let e=new mt(new lr(2*T0,2*T0),this.floorMaterial),t=this.makeGrid();e.renderOrder=-2,t.renderOrder=-1,this.ground.add(e,t),this.group.add(this.ground,this.fixed.group,this.things.group),this.group.visible=!1}get solids(){return this.all}poseOf(e){return this.things.poseOf(e.name)??e}setSolids(e,t){this.all=e,this.fixed.show(e.filter(({movable:n})=>!n)),this.things.show(e.filter(({movable:n})=>n)),this.floorColour.setRGB(...t,Ht),this.group.visible=!0,this.setDark(this.dark)}setDark(e){this.dark=e;let t=this.floorColour.getHSL({h:0,s:0,l:0},Ht),{h:n,s,l:r}=t.s<.05?{h:.58,s:e?.16:.1,l:t.l}:t,o=e?.09+.1*r:.72+.16*r;this.floorMaterial.color.setHSL(n,Math.min(s,.35),o,Ht),this.lineMaterial.color.setHSL(n,Math.min(s,.35),o+(e?.09:-.07),Ht),this.fixed.brightness=e?A0:1,this.things.setBrightness(e?A0:1)}put(e,t){let{x:n,y:s,z:r,yaw:o}=w0(e);this.group.position.set(n,s,r),this.group.rotation.z=o,this.group.updateMatrixWorld(),this.things.after(t)}centreOn(e,t){this.ground.position.set(Math.round(e),Math.round(t),0)}see(e,t){this.fixed.see(this.group.worldToLocal(e.position.clone()),t)}makeGrid(){let{half_m:e,every_m:t,piece_m:n}=ST,s=[];for(let r=-e;r<=e;r+=t)for(let o=-e;o<e;o+=n)s.push(o,r,0,o+n,r,0,r,o,0,r,o+n,0);return new co(new Vt().setAttribute("position",new ut(s,3)),this.lineMaterial)}};var ET=300,TT=.5,Ih=class{constructor(e,t,n){this.scene=e;let[s]=t.soles;this.marks=new Eh({length:s.size[0],width:s.size[1],ahead:s.centre[0]},e.size_m,{left:0,right:0,goal:0}),this.ghost=new Th(t),this.world.group.add(this.marks.group,this.ghost.group),e.onBeforeDraw=(r,o,a)=>{this.settle(r),this.world.see(o,a)},e.onPaint=({way:r},o)=>{this.marks.setColours(r),this.world.setDark(o)},e.add(this.world.group),e.showWorld(),e.repaint(),this.ghost.body.loadMeshes(n,()=>e.ask()).catch(()=>{})}world=new Ph;frame=new Sh;marks;ghost;odometry={x:0,y:0,z:0,yaw:0};run;drawn_ms=0;ask(){this.scene.ask()}setSolids(e,t){this.world.setSolids(e,t),this.scene.hazeAfter=e.length>ET?9:11,this.scene.ask()}show(e,t){this.frame.take(t??(this.frame.isKnown?void 0:e.odometry),e.run)&&this.scene.forgetSteps(),this.world.things.move(e.things,e.run!==this.run),this.run=e.run,this.scene.ask()}hitAt(e,t){if(!this.scene.gripAt(e,t))return v0(this.rayAt(e,t),this.world.solids,n=>this.world.poseOf(n))}levelAt(e,t,n){let{origin:s,direction:r}=this.rayAt(e,t),o=(n-s[2])/r[2];if(o>0&&o<100)return[s[0]+o*r[0],s[1]+o*r[1],n]}robotPlace(){let{position:e,quaternion:{x:t,y:n,z:s,w:r}}=this.scene.body.base,o=_f(this.odometry,e);return{x:o.x,y:o.y,yaw:this.odometry.yaw+Math.atan2(2*(t*n+r*s),1-2*(n*n+s*s))}}showGoal(e){this.marks.showGoal(e,this.height),this.ghost.show(e.x,e.y,this.height(e.x,e.y),e.yaw),this.scene.ask()}showPlan(e){e?this.marks.showPlan(e,this.height):this.marks.clearSteps(),this.scene.ask()}fadeSteps(e){this.marks.fade(e),this.scene.ask()}clearWay(){this.marks.clear(),this.ghost.hide(),this.scene.ask()}height=(e,t)=>b0(this.world.solids,e,t);rayAt(e,t){let{ray:n}=this.scene.rayAt(e,t);return n.applyMatrix4(this.world.group.matrixWorld.clone().invert()),{origin:n.origin.toArray(),direction:n.direction.toArray()}}settle(e){let t=Math.min((e-this.drawn_ms)/1e3,TT);this.drawn_ms=e,this.odometry=this.frame.after(t)??this.odometry,this.world.put(this.odometry,t);let{x:n,y:s}=_f(this.odometry,this.scene.body.base.position);this.world.centreOn(n,s)}};var Mr=(i,e=600,t=.001)=>({kind:"number",key:"duration_s",name:"for",unit:"s",value:i,least:t,most:e}),Lh=(i,e,t)=>({kind:"number",key:i,name:e,unit:"%",value:t,least:0,most:100}),R0=[{fault:"lose_frames",title:"Frames are lost",text:"Each frame on the bus is lost with this probability.",fields:[Lh("probability","lost",2),Mr(2)]},{fault:"disturb_bus",title:"The bus is disturbed",text:"Attempts to send a frame meet errors; the bus repeats them.",fields:[Lh("corruption","corrupted",1),Lh("omission","left out",.1),Lh("duplicate","doubled",.1),Mr(10)]},{fault:"jam",title:"The bus is jammed",text:"Nobody can send for so long.",fields:[Mr(.002,10,1e-5),{kind:"choice",key:"stuck",name:"by",of:[{value:"",text:"noise"},{value:"true",text:"a line that is stuck"}]}]},{fault:"bus_off",title:"A station is bus-off",text:"Its frames are destroyed until it leaves the bus; it comes back as the standard has it.",fields:[{kind:"choice",key:"node",name:"station",of:"nodes"}]},{fault:"joint_restarts",title:"A joint restarts",text:"Its controller is without power for a while, its motor without torque.",fields:[{kind:"choice",key:"joint",name:"joint",of:"joints"},Mr(.02,60)]},{fault:"main_controller_silent",title:"Main controller silent",text:"It makes no tick for so long: the message controller plays the safe tail.",fields:[Mr(1)]},{fault:"plugin_fails",title:"A plug-in fails",text:"Its steps fail for so long; the manager falls back on what it has. One that fails too often is out of service until it is reloaded (view Plug-ins).",fields:[{kind:"choice",key:"plugin",name:"plug-in",of:"plugins"},{kind:"choice",key:"how",name:"it",of:[{value:"throws",text:"throws"},{value:"not_a_number",text:"gives no numbers"},{value:"jumps",text:"gives nonsense"},{value:"overruns",text:"takes too long"}]},Mr(1)]},{fault:"sensor_fails",title:"A sensor fails",text:"It tells something else than what is; of a joint, its encoder.",fields:[{kind:"choice",key:"sensor",name:"sensor",of:"sensors"},{kind:"choice",key:"how",name:"it",of:[{value:"freezes",text:"freezes"},{value:"reads_zero",text:"reads zero"},{value:"noisy",text:"is noisy"}]},Mr(.5)]}];function C0(i,e){let t={kind:i.fault};for(let n of i.fields){let s=(e.get(n.key)??"").trim();if(n.kind==="choice"){if(s===""&&typeof n.of=="string")throw new Error(`${i.title}: no ${n.name} is chosen`);s!==""&&(t[n.key]=s==="true"?!0:s);continue}let r=Number(s);if(s===""||!(r>=n.least&&r<=n.most))throw new Error(`${i.title}: “${n.name}” is '${s}', and must be ${n.least} … ${n.most} ${n.unit}`);t[n.key]=n.unit==="%"?Number((r/100).toPrecision(12)):r}return{fault:t}}function AT(i,e){return(typeof i.of=="string"?e[i.of].map(n=>({value:n,text:n.replaceAll("_"," ")})):i.of).map(({value:n,text:s})=>O("option",{value:n},s))}function RT(i,e,t){let n=`fault-${i.fault}-${e.key}`;if(e.kind==="choice"){let r=O("select",{id:n},...AT(e,t));return{label:O("label",{for:n},e.name,r),input:r}}let s=O("input",{id:n,type:"number",step:"any",min:e.least,max:e.most,value:e.value});return{label:O("label",{for:n},e.name,s,e.unit),input:s}}function P0({attempt:i,description:e,robot:t},n){let s=e.joints.map(({name:h})=>h),r={joints:s,nodes:["message_controller",...s],plugins:[],sensors:["imu","left_foot","right_foot",...s]},o,a=R0.map(h=>{let u=h.fields.map(f=>({field:f,...RT(h,f,r)}));for(let{field:f,input:g}of u)f.kind==="choice"&&f.of==="plugins"&&(o=g);let d=O("form",{class:"card fault",id:`fault-${h.fault}`,novalidate:!0},O("header",{},O("h2",{},h.title),O("button",{type:"submit","aria-label":`${h.title}: now`},"Now")),O("p",{class:"note"},h.text),O("div",{class:"fields"},...u.map(({label:f})=>f)));return d.addEventListener("submit",f=>{f.preventDefault(),i(h.title,()=>n.apply(C0(h,new Map(u.map(({field:g,input:y})=>[g.key,y.value])))),"applied")}),d}),l=O("p",{class:"note",role:"status"}),c=async()=>{let{plugins:h}=await t.order("/plugins/list"),u=o?.value;o?.replaceChildren(...h.filter(({name:d})=>d!=="api").map(({name:d})=>O("option",{value:d,selected:d===u},d)))};return{title:"Faults",content:O("div",{class:"faults"},O("p",{class:"hint"},"What goes wrong with the simulated robot, from now on. The time line keeps a mark of it: drag back to before, and it never was."),...a,l),show:()=>void c().then(()=>Be(l,""),h=>Be(l,`The plug-ins are not known: ${h.message}`))}}var Dh=i=>Math.round(i*1e3)/1e3+0;function bf(i,[e,t,n]){return i==="sphere"?[e,e,e]:i==="cylinder"?[e,e,n]:[e,t,n]}function CT(i){let e=/^#[0-9a-f]{6}$/i.test(i)?parseInt(i.slice(1),16):8421504;return[e>>16,e>>8&255,e&255].map(t=>Math.round(t/255*1e3)/1e3)}function k0(i,e){for(let t=1;;++t){let n=t===1?i:`${i}_${t}`;if(!e.has(n))return n}}function F0(i,e,t,n=0){let s=bf(i.shape,i.size),r=i.mass_kg===void 0?{}:{mass_kg:i.mass_kg};return{spawn:{name:e,shape:i.shape,size_m:s,position_m:[Dh(t[0]),Dh(t[1]),Dh(t[2]+s[2]/2)],yaw_deg:n,...r,colour:CT(i.colour)}}}function U0(i,e,t){return{move:{name:i,position_m:e.map(Dh),yaw_deg:Math.round(t*1800/Math.PI)/10+0}}}function O0(i){return{remove:{name:i}}}function Va({kind:i,movable:e}){return e||i==="thing"||i==="box"}var I0=.01,L0=5,D0=.001,N0=1e3;function B0({size:i,mass_kg:e}){for(let[t,n]of i.entries())if(!(n>=I0&&n<=L0))throw new Error(`${["length","width","height"][t]} is ${n} m, and must be ${I0} … ${L0} m`);if(e!==void 0&&!(e>=D0&&e<=N0))throw new Error(`mass is ${e} kg, and must be ${D0} … ${N0} kg`)}var PT=300,IT=.01,Nh=class{constructor(e,t,n,s){this.picture=e;this.canvas=t;this.tools=n;this.user=s;t.after(this.label);let r=(o,a)=>t.addEventListener(o,a,{capture:!0});r("pointerdown",o=>this.begin(o)),r("pointermove",o=>this.move(o)),r("pointerup",o=>void this.end(o)),r("pointercancel",()=>this.cancel()),t.addEventListener("pointerleave",()=>this.label.hidden=!this.drag),window.addEventListener("keydown",o=>o.key==="Escape"&&this.cancel(),{capture:!0})}on=!1;places=!1;label=O("p",{class:"push-label",hidden:!0});drag;onToggle=()=>{};setOn(e){e!==this.on&&(this.on=e,e?this.tools.choose(this):(this.cancel(),this.label.hidden=!0,this.places=!1),this.canvas.classList.toggle("places",e),this.onToggle(e))}cancel(){let{drag:e}=this;this.drag=void 0,e&&(this.putBack(e),this.label.hidden=!0)}begin(e){if(this.drag){this.cancel();return}let t=this.on&&e.button===0?this.picture.hitAt(e.clientX,e.clientY):void 0;if(!t)return;let n=t.solid&&Va(t.solid)?t.solid:void 0;if(!n){if(!this.places)return;e.stopImmediatePropagation(),this.user.place(t.place);return}e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId),this.letGo();let s=this.picture.world.poseOf(n);this.drag={pointer:e.pointerId,solid:n,pose:s,grip:t.place,at:s.place,moved:!1},this.user.choose(n)}move(e){let{drag:t}=this;if(t||this.tellThing(e),!t||e.pointerId!==t.pointer)return;e.stopImmediatePropagation();let n=this.picture.levelAt(e.clientX,e.clientY,t.grip[2]);if(!n)return;let[s,r]=[n[0]-t.grip[0],n[1]-t.grip[1]];t.moved||=Math.hypot(s,r)>IT,t.moved&&(t.at=[t.pose.place[0]+s,t.pose.place[1]+r,t.pose.place[2]],this.picture.world.things.hold(t.solid,{place:t.at,turn:t.pose.turn}),this.picture.ask(),this.tell(e,`${t.solid.name}: x ${t.at[0].toFixed(2)} m, y ${t.at[1].toFixed(2)} m`))}async end(e){let{drag:t}=this;if(!t||e.pointerId!==t.pointer||(e.stopImmediatePropagation(),this.drag=void 0,this.label.hidden=!0,!t.moved))return;await this.user.move(t.solid,t.at,Zs(t.pose.turn))?setTimeout(()=>!this.drag&&this.letGo(),PT):this.putBack(t)}putBack({solid:e,moved:t,pose:n}){t&&(this.picture.world.things.hold(e,n),this.letGo())}letGo(){this.picture.world.things.letGo(),this.picture.ask()}tellThing(e){let t=this.on&&e.buttons===0&&e.pointerType==="mouse"?this.picture.hitAt(e.clientX,e.clientY):void 0,n=t?.solid&&Va(t.solid)?t.solid:void 0;this.label.hidden=!n&&!(t&&this.places),n?this.tell(e,`${n.name}: drag to move`):t&&this.places&&this.tell(e,"Put it here")}tell(e,t){Be(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}};var z0=[{shape:"box",text:"Box",size:[.2,.2,.1],measures:["length","width","height"]},{shape:"cylinder",text:"Cylinder",size:[.15,.15,.2],measures:["diameter","","height"]},{shape:"sphere",text:"Ball",size:[.15,.15,.15],measures:["diameter","",""]}],wf=class{box;shape="box";measures=[0,1,2].map(e=>O("input",{type:"number",id:`thing-size-${e}`,min:1,max:500,step:"any"}));labels=this.measures.map(e=>{let t=O("span");return{name:t,label:O("label",{},t,e,"cm")}});fast=O("input",{type:"checkbox",id:"thing-fast"});mass=O("input",{type:"number",id:"thing-mass",min:.001,step:"any",value:.5});colour=O("input",{type:"color",id:"thing-colour",value:"#e08a2b"});buttons;constructor(){this.buttons=z0.map(({shape:e,text:t})=>Qe(t,()=>this.choose(e),{"aria-pressed":"false",id:`thing-${e}`})),this.fast.addEventListener("change",()=>this.mass.disabled=this.fast.checked),this.box=O("div",{class:"thing-form"},O("div",{class:"buttons",role:"group","aria-label":"Shape"},...this.buttons),O("div",{class:"fields"},...this.labels.map(({label:e})=>e),O("label",{},"mass",this.mass,"kg"),O("label",{class:"check"},this.fast,"stands fast"),O("label",{},"colour",this.colour))),this.choose("box")}get thing(){let e=this.measures.map(n=>Number(n.value)/100),t={shape:this.shape,size:bf(this.shape,e),mass_kg:this.fast.checked?void 0:Number(this.mass.value),colour:this.colour.value};return B0(t),t}choose(e){this.shape=e;for(let[t,n]of z0.entries())if(this.buttons[t].setAttribute("aria-pressed",String(n.shape===e)),n.shape===e)for(let[s,{name:r,label:o}]of this.labels.entries())Be(r,n.measures[s]),o.hidden=n.measures[s]==="",this.measures[s].value=String(Math.round(n.size[s]*1e3)/10)}};function H0({attempt:i,news:e},t,n,s,r){let o=new wf,a=O("ul",{class:"things","aria-label":"Things that can be moved"}),l=O("p",{class:"hint",role:"status"}),c,h=!1,u=w=>{try{let{thing:x}=o,P=k0(x.shape,new Set(n.world.solids.map(A=>A.name)));i(`New ${P}`,()=>t.apply(F0(x,P,w)))}catch(x){e.say(`It was not put there: ${x.message}`,"bad","thing")}},d=w=>void i(`Take ${w} away`,()=>t.apply(O0(w))),f=(w,x,P)=>i(`Move ${w.name}`,()=>t.apply(U0(w.name,x,P))),g=w=>{c=w?.name,b(),a.querySelector("[aria-current]")?.scrollIntoView({block:"nearest"})},y=new Nh(n,s,r,{place:u,choose:g,move:f}),m=Qe("Put it where I click",()=>{let w=!(y.on&&y.places);y.setOn(!0),y.places=w,p()},{id:"thing-put",class:"primary","aria-pressed":"false"}),p=()=>{let w=y.on&&y.places;m.setAttribute("aria-pressed",String(w)),Be(m,w?"Click a place in the picture":"Put it where I click"),Be(l,a.childElementCount===0?"Nothing here can be moved yet.":"Drag a thing in the picture to move it.")},b=()=>{let w=n.world.solids.filter(x=>!Ba(x)&&Va(x)&&(x.movable||x.kind==="thing"||x.name===c));a.replaceChildren(...w.map(x=>O("li",x.name===c?{"aria-current":"true"}:{},O("span",{},x.name),Qe("Take away",()=>d(x.name),{"aria-label":`Take ${x.name} away`})))),p()};return y.onToggle=p,{title:"Things",tool:y,content:O("div",{class:"things-tab"},O("h2",{},"A new thing"),o.box,m,O("h2",{},"What can be moved"),l,a),show:()=>{h=!0,y.setOn(!0),b()},hide:()=>{h=!1,r.done(y)},worldChanged:()=>h&&b()}}function LT(i){return typeof i=="string"?[...atob(i)].map(e=>e.charCodeAt(0)):Array.isArray(i)?i.map(Number):[]}function G0(i){let e=LT(i.sides),t=i.steps.map(Number),n=i.feet.map(Number);if(t.length!==3*e.length||n.length!==6||![...t,...n].every(Number.isFinite))throw new Error(`the plan has ${e.length} sides, ${t.length} numbers of steps and ${n.length} of feet: three a step and six are wanted`);let s=(r,o)=>({x:r[3*o],y:r[3*o+1],yaw:r[3*o+2]});return{steps:e.map((r,o)=>({side:r===1?1:0,...s(t,o)})),feet:[s(n,0),s(n,1)],seconds:Number(i.duration)}}function V0([i,e]){let t=Math.atan2(Math.sin(i.yaw)+Math.sin(e.yaw),Math.cos(i.yaw)+Math.cos(e.yaw));return{x:(i.x+e.x)/2,y:(i.y+e.y)/2,yaw:t}}function W0({steps:i,feet:e}){let t=[...e],n=[{at:V0(t),gone_m:0}];for(let s of i){t[s.side]=s;let[r,o]=[n[n.length-1],V0(t)];n.push({at:o,gone_m:r.gone_m+Math.hypot(o.x-r.at.x,o.y-r.at.y)})}return n}function X0(i){return W0(i).at(-1)?.gone_m??0}var DT=.02;function Mf(i,{x:e,y:t},n=0){let s=W0(i),r=.5,o=s[n],a={gone_m:o.gone_m,off_m:1/0};for(let c=n;c<s.length&&s[c].gone_m<o.gone_m+r;++c){let[h,u]=[s[c],s[c+1]??s[c]],[d,f]=[u.at.x-h.at.x,u.at.y-h.at.y],g=d*d+f*f,y=g>0?Math.min(Math.max(((e-h.at.x)*d+(t-h.at.y)*f)/g,0),1):0,m=Math.hypot(e-h.at.x-y*d,t-h.at.y-y*f);m<a.off_m-1e-9&&(a={gone_m:h.gone_m+y*(u.gone_m-h.gone_m),off_m:m})}let l=n;for(;l+1<s.length&&s[l+1].gone_m<=a.gone_m+DT;)l+=1;return{passed:l,left_m:Math.max(X0(i)-a.gone_m,0)}}function $0(i,e){return Math.min(Math.max(i.steps.length-e,0),i.steps.length)}function q0(i){let e=`${i.steps.length} step${i.steps.length===1?"":"s"}`,t=Number.isFinite(i.seconds)&&i.seconds>0?`, about ${i.seconds.toFixed(0)} s`:"";return`${e}, ${X0(i).toFixed(1)} m${t}`}var NT=.08;function Sf(i,e,t){let[n,s]=i;if(Math.hypot(e[0]-n,e[1]-s)>NT)return{x:n,y:s,yaw:Math.atan2(e[1]-s,e[0]-n)};let o=!t||Math.hypot(n-t.x,s-t.y)<.25;return{x:n,y:s,yaw:o?t?.yaw??0:Math.atan2(s-t.y,n-t.x)}}function Y0({x:i,y:e,yaw:t}){let n=s=>s.toFixed(2).replace("-","−");return`x ${n(i)} m, y ${n(e)} m, ${(t*180/Math.PI).toFixed(0).replace("-","−")}°`}var Z0=1,K0=101,kT=1,FT=2,Ga=5e3,Ef=15e3,UT=1e4,kh=class{constructor(e){this.robot=e}async play(){await this.ask("set_simulation_state",{state:{state:kT}},Ga,K0)}async pause(){await this.ask("set_simulation_state",{state:{state:FT}},Ga,K0)}async step(e){await this.ask("step_simulation",{steps:e},Ef)}async reset(){await this.ask("reset_simulation",{scope:0},Ef)}async setSpeed(e){await this.robot.order("/simulation/set_speed",{speed:e},Ga)}async seek(e){await this.robot.order("/simulation/seek",{time:e},Ef)}async apply(e){await this.robot.order("/simulation/apply",{event:JSON.stringify(e)},Ga)}async plan({x:e,y:t,yaw:n}){return G0(await this.robot.order("/simulation/plan",{x:e,y:t,yaw:n},UT))}async geometry(e){return y0(await this.robot.order("/simulation/geometry",{first:e},Ga))}async ask(e,t,n,s=Z0){let{result:r}=await this.robot.call(`/simulation/${e}`,t,n);if(!(r?.result===Z0||r?.result===s))throw new Xn(r?.error_message||`/simulation/${e} was refused with result ${r?.result}`)}};var OT=60,J0=.05,j0=.5,Q0=([i,e])=>1-2*(i*i+e*e);function BT(i,e){let t=za(i.yaw-e.yaw),[n,s]=[Math.cos(t),Math.sin(t)];return{x:i.x-(n*e.x-s*e.y),y:i.y-(s*e.x+n*e.y),z:i.z-e.z,yaw:t}}var Fh=class{trail=[];take({robot_time:e,base_place:t,base_height:n,base_turn:s}){let[r=NaN,o=NaN,a=NaN,l=NaN]=[e[0],...t,n[0]],c=s;!Number.isFinite(r+o+a+l+(c[3]??NaN))||Q0(c)<j0||(r<(this.trail.at(-1)?.time_s??0)&&(this.trail=[]),r===this.trail.at(-1)?.time_s&&this.trail.pop(),this.trail.push({time_s:r,seen:{x:o,y:a,z:l,yaw:Zs(c)}}),this.trail.length>OT&&this.trail.shift())}forget(){this.trail=[]}originFor({time_s:e,base:t,state:n,speed:s}){let r=t&&Q0(t.turn)>=j0?this.at(e,n==="playing"?J0*Math.max(s,1):J0):void 0;return t&&r&&BT(zT(t),r)}at(e,t){let n=this.trail.findIndex(l=>l.time_s>=e),[s,r]=[this.trail[n<0?this.trail.length-1:Math.max(n-1,0)],this.trail[n]];if(!r)return s&&e-s.time_s<=t?s.seen:void 0;if(!s||r.time_s<=s.time_s)return r.time_s-e<=t?r.seen:void 0;let o=(e-s.time_s)/(r.time_s-s.time_s),a=l=>s.seen[l]+o*(r.seen[l]-s.seen[l]);return{x:a("x"),y:a("y"),z:a("z"),yaw:s.seen.yaw+o*za(r.seen.yaw-s.seen.yaw)}}};function zT({place:[i,e,t],turn:n}){return{x:i,y:e,z:t,yaw:Zs(n)}}function Wa({recorded_s:i}){return Math.max(i,1)}function Xa(i,e){return Math.min(Math.max(i/e,0),1)}function Tf(i,{recorded_s:e}){let t=Math.min(Math.max(i,0)*Wa({recorded_s:e}),e);return Math.min(Math.round(t*1e3),Math.floor(e*1e3+1e-6))/1e3}var jn=i=>`${i.toFixed(3)} s`,HT=5e-4;function Uh(i,e){let t=e-i;return t>HT?`The ${jn(t)} after this instant will be forgotten when it plays on.`:""}var e_={command:"command",push:"push",fault:"fault",world:"change of the world",fall:"fall"};function t_(i,e,t){let n=[],s=new Map;for(let{at_s:r,kind:o}of[...i].sort((a,l)=>a.at_s-l.at_s)){let a=Xa(r,e),l=s.get(o);if(l&&a-l.share<t){l.count+=1;continue}let c={share:a,kind:o,count:1,at_s:r};n.push(c),s.set(o,c)}return n}function n_({kind:i,count:e,at_s:t}){return e===1?`${e_[i]} at ${jn(t)}`:`${e} × ${e_[i]} from ${jn(t)}`}function i_(i){return[.1,.2,.5,1,2,5,10,20,30,60,120,300,600,1200,1800,3600].find(t=>i/t<=10)??Math.ceil(i/36e3)*3600}function s_(i){return new Promise(e=>{let t=O("dialog",{id:"reset-dialog","aria-labelledby":"reset-title"},O("h2",{id:"reset-title"},"Back to 0 s?"),O("p",{},`The robot and the world begin anew, and the ${jn(i)} that are recorded are forgotten.`),O("div",{class:"answers"},Qe("Keep it",()=>t.close(),{class:"plain",id:"reset-keep"}),Qe("Reset",()=>t.close("reset"),{id:"reset-go"})));t.addEventListener("close",()=>{t.remove(),e(t.returnValue==="reset")}),document.body.append(t),t.showModal()})}var Oh=class{constructor(e,t,n=()=>performance.now()){this.seek=e;this.failed=t;this.now_ms=n}wish_s;goes=!1;arrived_ms=0;target_s;get isGoing(){return this.goes}async to(e){if(this.wish_s=e,this.target_s=e,!this.goes){this.goes=!0;try{for(;this.wish_s!==void 0;){let t=this.wish_s;this.wish_s=void 0,await this.seek(t)}}catch(t){this.wish_s=this.target_s=void 0,this.failed(t)}finally{this.goes=!1,this.arrived_ms=this.now_ms()}}}told(e){this.goes||this.target_s===void 0||(Math.abs(e-this.target_s)<.0015||this.now_ms()-this.arrived_ms>500)&&(this.target_s=void 0)}};var VT={ArrowLeft:-.1,ArrowRight:.1,PageDown:-1,PageUp:1},GT=5,Bh=class{constructor(e,t){this.seek=e;this.target=t;this.line=O("div",{class:"time-line",id:"time-line",role:"slider",tabindex:0,"aria-label":"Time line","aria-valuemin":0,title:"Click or drag: go to this instant. Arrows: 0.1 s, with Shift 1 s"},O("div",{class:"future"}),O("div",{class:"past"}),this.ticks,this.marks,O("div",{class:"head"}),this.bubble),this.box=O("div",{class:"time-line-box"},this.line),this.line.addEventListener("pointerdown",n=>this.begin(n)),this.line.addEventListener("pointermove",n=>this.move(n)),this.line.addEventListener("pointerup",n=>this.end(n)),this.line.addEventListener("pointercancel",()=>this.end()),this.line.addEventListener("pointerleave",()=>this.bubble.hidden=this.pointer===void 0),this.line.addEventListener("keydown",n=>this.key(n))}box;line;ticks=O("div",{class:"ticks"});marks=O("div",{class:"marks"});bubble=O("span",{class:"bubble",hidden:!0});state;pointer;dragged_s;drawnMarks="";drawnTicks="";show(e){this.state=e;let t=Wa(e),n=this.dragged_s??this.target()??e.time_s;this.line.style.setProperty("--now",String(Xa(n,t))),this.line.style.setProperty("--recorded",String(Xa(e.recorded_s,t))),this.line.classList.toggle("forgets",e.state!=="playing"&&Uh(n,e.recorded_s)!==""),this.line.setAttribute("aria-valuemax",e.recorded_s.toFixed(3)),this.line.setAttribute("aria-valuenow",n.toFixed(3)),this.line.setAttribute("aria-valuetext",`${jn(n)} of ${jn(e.recorded_s)}`),this.showMarks(e,t),this.showTicks(t)}get time_s(){return this.dragged_s??this.target()}showMarks(e,t){let n=Math.max(this.line.clientWidth,100),s=t_(e.marks,t,GT/n),r=s.map(({share:o,kind:a,count:l})=>`${a}${Math.round(o*n)}x${l}`).join();r!==this.drawnMarks&&(this.drawnMarks=r,this.marks.replaceChildren(...s.map(o=>{let a=e.events.find(({at_s:c})=>Math.abs(c-o.at_s)<.0015),l=O("i",{class:o.kind,title:n_(o)+(a&&o.count===1?`: ${a.text}`:"")});return l.style.setProperty("--at",String(o.share)),l})))}showTicks(e){let t=i_(e),n=Math.floor(e/t+1e-9),s=`${t}x${n}/${Math.round(this.line.clientWidth)}`;for(let r of this.ticks.children)r.style.setProperty("--at",String(Number(r.dataset.s)/e));s!==this.drawnTicks&&(this.drawnTicks=s,this.ticks.replaceChildren(...Array.from({length:n+1},(r,o)=>{let a=o*t,l=O("b",{"data-s":a},t<1?a.toFixed(1):a.toFixed(0));return l.style.setProperty("--at",String(a/e)),l})))}instant(e){let{left:t,width:n}=this.line.getBoundingClientRect();return this.state?Tf((e.clientX-t)/n,this.state):0}begin(e){e.button!==0||!this.state||(this.pointer=e.pointerId,this.line.setPointerCapture(e.pointerId),this.go(e))}move(e){e.pointerId===this.pointer?this.go(e):e.buttons===0&&this.tell(e)}end(e){e&&e.pointerId!==this.pointer||(this.pointer=void 0,this.dragged_s=void 0,e?.pointerType!=="mouse"&&(this.bubble.hidden=!0))}go(e){this.tell(e);let t=this.instant(e);t!==this.dragged_s&&(this.dragged_s=t,this.seek(t),this.state&&this.show(this.state))}tell(e){if(!this.state)return;let t=this.instant(e);Be(this.bubble,jn(t)),this.bubble.style.setProperty("--at",String(Xa(t,Wa(this.state)))),this.bubble.hidden=!1}key(e){let t=VT[e.key],n={Home:0,End:this.state?.recorded_s??0};if(!this.state||t===void 0&&n[e.key]===void 0)return;e.preventDefault(),e.stopPropagation();let s=this.time_s??this.state.time_s,r=t===void 0?n[e.key]??0:s+t*(e.shiftKey?10:1);this.seek(Tf(r/Wa(this.state),this.state)),this.show(this.state)}};var WT=[.1,.2,.5,1,2,5,10,20,40],r_=[1,10,80],XT=i=>i===""?"":`${i[0].toUpperCase()}${i.slice(1)}.`,zh=class{constructor(e,t,n){this.context=e;this.orders=t;this.seeker=new Oh(r=>this.leaveNow(()=>t.seek(r)),r=>e.news.say(`Going to an instant: ${r.message}`,"bad","seek")),this.timeLine=new Bh(r=>void this.seeker.to(r),()=>this.seeker.target_s),this.playButton=Qe("",()=>this.playOrPause(),{id:"play",class:"play","aria-keyshortcuts":"Space"}),this.stepButtons=r_.map(r=>Qe(String(r),()=>this.step(r),{id:`step-${r}`,"aria-label":`One step of ${r} ms`})),this.speed=O("select",{id:"speed","aria-label":"Speed, in times real time",title:"Speed, in times real time"},...WT.map(r=>this.speedOption(r))),this.speed.addEventListener("change",()=>{this.setSpeed(Number(this.speed.value)),this.speed.blur()});let s=Qe("Reset",()=>void this.reset(),{id:"reset",title:"Back to 0 s; what is recorded is forgotten"});this.box=O("section",{id:"simulator",class:"simulator","aria-label":"Simulator"},O("div",{class:"simulator-row"},this.playButton,O("span",{class:"steps",role:"group","aria-label":"Single steps"},O("small",{},"Step"),...this.stepButtons,O("small",{},"ms")),O("span",{class:"speed"},this.speed,this.pace),O("span",{class:"clocks"},this.clock,this.recorded),O("span",{class:"menus"},...n,s)),this.timeLine.box,this.note),this.nameSteps(),document.addEventListener("keydown",r=>this.key(r))}box;playButton;stepButtons;speed;pace=O("span",{class:"pace",title:"How fast it is, measured"});clock=O("output",{class:"clock",id:"simulator-time",title:"Simulated time"});recorded=O("span",{class:"recorded",title:"What has been simulated"});note=O("p",{class:"simulator-note",id:"simulator-note",role:"status"});timeLine;seeker;step_ms=10;state;silent=!1;show(e){this.state=e,this.seeker.told(e.time_s);let t=e.state==="playing",n=t?"Pause (Space)":"Play (Space)";this.playButton.classList.toggle("plays",t),this.playButton.title=n,this.playButton.setAttribute("aria-label",n),this.showSpeed(e);let s=this.timeLine.time_s??e.time_s;Be(this.clock,jn(s)),Be(this.recorded,`of ${jn(e.recorded_s)}`),this.timeLine.show(e),this.tell(e,s)}setSilent(e){e!==this.silent&&(this.silent=e,this.box.classList.toggle("silent",e),this.state&&this.tell(this.state,this.state.time_s))}tell(e,t){let n=e.state==="playing"?"":Uh(t,e.recorded_s),s=this.silent?"The simulator does not answer.":e.state==="failed"?`The simulator has failed: ${e.text||"it does not say why"}`:e.state==="busy"?`Busy: ${e.text||"…"}`:this.seeker.isGoing&&this.seeker.target_s!==void 0?`Going to ${jn(this.seeker.target_s)}…`:e.fallen?`The robot has fallen. ${n||"Drag the time line back to before, or reset."}`:n||XT(e.text);Be(this.note,s),this.note.className=`simulator-note${this.silent||e.state==="failed"?" bad":e.state==="busy"?" busy":e.fallen?" caution":""}`}playOrPause(){let e=this.state?.state==="playing";this.quietly(e?"Pause":"Play",()=>e?this.orders.pause():this.orders.play())}step(e){this.step_ms=e,this.nameSteps(),this.quietly(`Step of ${e} ms`,async()=>{this.state?.state==="playing"&&await this.orders.pause(),await this.orders.step(e)})}nameSteps(){for(let[e,t]of r_.entries()){let n=t===this.step_ms?" (.)":"";this.stepButtons[e].title=`One step of ${t} ms${n}`}}setSpeed(e){this.quietly(`Speed ${e}`,()=>this.orders.setSpeed(e))}showSpeed({state:e,speed:t,pace:n}){document.activeElement!==this.speed&&Number(this.speed.value)!==t&&([...this.speed.options].some(r=>Number(r.value)===t)||this.speed.append(this.speedOption(t)),this.speed.value=String(t));let s=e==="playing"&&Number.isFinite(n);Be(this.pace,s?`is ${n.toFixed(n<9.95?2:1)}`:""),this.pace.classList.toggle("bad",s&&n<.8*t)}speedOption(e){return O("option",{value:e},`${e} ×`)}async reset(){await s_(this.state?.recorded_s??0)&&await this.context.attempt("Reset",()=>this.leaveNow(()=>this.orders.reset()))}async leaveNow(e){let{command:t}=this.context;t.mine&&await t.giveBack().catch(()=>{}),await e()}async quietly(e,t){try{await t()}catch(n){this.context.news.say(`${e}: ${n.message}`,"bad",e)}}key(e){if(!(this.silent||!this.state||qs(e.target)||e.ctrlKey||e.altKey||e.metaKey||document.querySelector("dialog[open]"))){if(e.code==="Space"&&!e.repeat)this.playOrPause();else if(e.key===".")this.step(this.step_ms);else if(e.code!=="Space")return;e.preventDefault()}}};var Hh=class{constructor(e,t,n,s,r){this.picture=e;this.canvas=t;this.tools=n;this.turnBySecond=s;this.user=r;this.toggle=Qe("Walk to",()=>this.setOn(!this.on),{"aria-pressed":"false",id:"walk-to",class:"walk-to",title:"Choose where the robot walks: click a place on the floor, drag for where it looks there"}),t.after(this.label);let o=(a,l)=>t.addEventListener(a,l,{capture:!0});o("pointerdown",a=>this.begin(a)),o("pointermove",a=>this.move(a)),o("pointerup",a=>this.end(a)),o("pointercancel",()=>this.cancel()),t.addEventListener("pointerleave",()=>this.label.hidden=!this.drag)}toggle;label=O("p",{class:"push-label",hidden:!0});drag;passes=!1;onToggle=()=>{};get on(){return this.toggle.getAttribute("aria-pressed")==="true"}setOn(e){e!==this.on&&(e&&this.tools.choose(this),this.toggle.setAttribute("aria-pressed",String(e)),this.canvas.classList.toggle("walks",e),this.turnBySecond(e),e||(this.cancel(),this.label.hidden=!0),this.onToggle(e))}cancel(){return this.drag?(this.drag=void 0,this.label.hidden=!0,this.user.broken(),!0):!1}floorAt(e){let t=this.picture.hitAt(e.clientX,e.clientY);if(t)return t.solid&&!Ba(t.solid)?{blocked:t.solid.name}:{place:[t.place[0],t.place[1]],height_m:t.place[2]}}begin(e){if(this.passes)return;if(this.drag){this.giveToCamera(this.drag.begun);return}let t=this.on&&e.button===0?this.floorAt(e):void 0;if(!t||"blocked"in t)return;e.stopImmediatePropagation(),this.canvas.setPointerCapture(e.pointerId);let n=Sf(t.place,t.place,this.picture.robotPlace());this.drag={pointer:e.pointerId,from:t.place,height_m:t.height_m,begun:e,goal:n},this.aim(e,n)}giveToCamera(e){this.cancel(),this.passes=!0,this.canvas.dispatchEvent(new PointerEvent(e.type,e)),this.passes=!1}move(e){if(this.drag||this.tellPlace(e),e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let t=this.picture.levelAt(e.clientX,e.clientY,this.drag.height_m);t&&(this.drag.goal=Sf(this.drag.from,[t[0],t[1]],this.picture.robotPlace())),this.aim(e,this.drag.goal)}end(e){if(e.pointerId!==this.drag?.pointer)return;e.stopImmediatePropagation();let{goal:t}=this.drag;this.drag=void 0,this.label.hidden=!0,this.user.choose(t)}aim(e,t){this.user.aim(t),this.tell(e,Y0(t))}tellPlace(e){let t=this.on&&e.buttons===0&&e.pointerType==="mouse"?this.floorAt(e):void 0;this.label.hidden=!t,t&&("blocked"in t?this.tell(e,`${t.blocked} stands here`):this.tell(e,"Walk here"))}tell(e,t){Be(this.label,t);let n=this.canvas.getBoundingClientRect();this.label.style.setProperty("--x",`${e.clientX-n.left}px`),this.label.style.setProperty("--y",`${e.clientY-n.top}px`),this.label.hidden=!1}};var Af={name:"/walk_to/state",type:"gaitway_msgs/msg/WayState"};function o_(i){let e=Array.isArray(i.goal)?i.goal.map(Number):[];return{goes:["plans","walks","waits"].includes(String(i.state)),result:String(i.result),text:String(i.text??""),stepsLeft:Number(i.steps_left),distanceLeft_m:Number(i.distance_left),replans:Number(i.replans),goal:e.length===3&&e.every(Number.isFinite)?{x:e[0],y:e[1],yaw:e[2]}:void 0}}function a_(i,e){return[Number.isFinite(e)?`${e.toFixed(1)} m`:"",i>0?`${i} step${i===1?"":"s"}`:""].filter(Boolean).join(", ")}var Rf=(i,e)=>Math.hypot(i.x-e.x,i.y-e.y)<.005&&Math.abs(Math.sin((i.yaw-e.yaw)/2))<.005;var $T=4e3,Vh=class{constructor(e,t){this.planner=e;this.walk=Qe("Walk",t.walk,{class:"primary",id:"way-walk",title:"The robot walks there (Enter)"}),this.cancel=Qe("Cancel",t.cancel,{id:"way-cancel",title:"Forget this goal (Escape)"}),this.leave=Qe("Leave the way",t.leave,{id:"way-leave",title:"The robot stands after its next steps"}),this.box=O("div",{class:"way-card",id:"way",role:"group","aria-label":"Walk to a place",hidden:!0},this.text,this.more,this.walk,this.cancel,this.leave)}box;text=O("p",{role:"status",id:"way-text"});walk;cancel;leave;arrivedUntil_ms=0;went=!1;more=O("small",{},"Turn the view: the right button, or two fingers.");toolOn=!1;forget(){this.arrivedUntil_ms=0,this.went=!1}show(e){let{draft:t,way:n}=this.planner,s=n?.goes??!1;this.went&&!s&&n?.result==="arrived"&&(this.arrivedUntil_ms=e+$T),this.went=s;let r=!s&&!t&&e<this.arrivedUntil_ms;this.box.className=`way-card${t?.refusal?" refused":t?.plan?" ready":s?" goes":r?" arrived":""}`;let o=this.words(r);Be(this.text,o),this.box.hidden=o==="";let a=!this.walk.hidden;this.more.hidden=t!==void 0||s||r,this.walk.hidden=!t?.plan,this.cancel.hidden=!t,this.leave.hidden=!s||t!==void 0,!a&&!this.walk.hidden&&(document.activeElement===document.body||document.activeElement===null)&&this.walk.focus({preventScroll:!0})}words(e){let{draft:t}=this.planner;if(t?.refusal!==void 0)return t.refusal;if(t?.plan)return t.plan.steps.length===0?"The robot stands there already.":q0(t.plan);if(t)return"Looking for a way…";let{left:n}=this.planner,s=n&&a_(n.steps,n.distance_m);return n?`On its way${s?`: ${s} left`:"…"}`:e?"Arrived.":this.toolOn?"Click the floor, then press Walk: the robot walks there. Drag to choose where it looks.":""}};var Gh=class{constructor(e){this.plan=e}draft;way;walked;place;asked;onChange=()=>{};async choose(e){let t={goal:e};this.draft=t,this.onChange();try{t.plan=await this.plan(e)}catch(n){t.refusal=`${n instanceof Xn?"No way leads there":"No plan has come"}: ${n.message}`}this.draft===t&&this.onChange()}discard(){this.draft&&(this.draft=void 0,this.onChange())}begun(){let{draft:e}=this;e?.plan&&(this.walked=this.beginning(e.goal,e.plan),this.asked={goal:e.goal,replans:this.way?.replans??0}),this.draft=void 0,this.onChange()}jumped(){this.walked=this.asked=this.way=void 0,this.draft&&this.choose(this.draft.goal),this.onChange()}take(e){this.way=e,e.goes&&e.goal?this.keepWalked(e.goal,e.replans):e.goes||(this.walked=this.asked=void 0),this.onChange()}at(e){this.place=e;let{walked:t,way:n}=this;if(!t||!n?.goes)return;let s=Mf(t.plan,e,t.progress.passed);s.passed=Math.max(Math.min(s.passed,$0(t.plan,n.stepsLeft)),t.progress.passed),t.progress=s,this.onChange()}get shown(){let{draft:e,way:t,walked:n}=this;return e?{goal:e.goal,plan:e.plan,passed:0}:n?{goal:n.goal,plan:n.plan,passed:n.progress.passed}:t?.goes&&t.goal?{goal:t.goal,plan:void 0,passed:0}:void 0}get left(){let{way:e,walked:t}=this;if(e?.goes)return t?{steps:t.plan.steps.length-t.progress.passed,distance_m:t.progress.left_m}:{steps:e.stepsLeft,distance_m:e.distanceLeft_m}}beginning(e,t){return{goal:e,plan:t,progress:Mf(t,this.place??t.feet[0])}}keepWalked(e,t){let{asked:n}=this;if(n&&Rf(n.goal,e)&&n.replans===t)return;if(n&&Rf(n.goal,e)&&this.walked&&t===0){this.asked={goal:e,replans:t};return}let s={goal:e,replans:t};this.asked=s,this.plan(e).then(r=>{this.asked===s&&(this.walked=this.beginning(e,r),this.onChange())},()=>{})}};var qT=15e3,Wh=class{constructor(e,t,n,s,r,o,a){this.context=e;this.orders=t;this.picture=n;this.plays=a;this.planner=new Gh(l=>t.plan(l)),this.card=new Vh(this.planner,{walk:()=>this.walk(),cancel:()=>this.planner.discard(),leave:()=>this.leave()}),this.tool=new Hh(n,r,o,l=>s.turnBySecond(l),{aim:l=>this.aim(l),choose:l=>{this.aimed=void 0,this.planner.choose(l)},broken:()=>this.aim(void 0)}),this.tool.onToggle=l=>{this.card.toolOn=l,l||this.planner.discard(),this.show()},this.planner.onChange=()=>this.show(),e.robot.subscribe(Af.name,Af.type,0,l=>this.planner.take(o_(l))),window.addEventListener("keydown",l=>{l.key!=="Escape"||!this.breakOff()||this.plays()||(l.preventDefault(),l.stopImmediatePropagation())},{capture:!0})}tool;card;planner;aimed;drawn;drawnGoal;jumped(){this.card.forget(),this.planner.jumped()}worldChanged(){this.drawn=this.drawnGoal=void 0,this.show()}look(e){this.planner.at(this.picture.robotPlace()),this.card.show(e)}breakOff(){let e=this.tool.cancel(),t=this.planner.draft!==void 0;return this.planner.discard(),e||t}aim(e){this.aimed=e,this.show()}show(){let e=this.aimed?{goal:this.aimed,plan:void 0,passed:0}:this.planner.shown;e?(e.goal!==this.drawnGoal&&this.picture.showGoal(e.goal),e.plan!==this.drawn&&this.picture.showPlan(e.plan),this.picture.fadeSteps(e.passed)):this.picture.clearWay(),this.drawn=e?.plan,this.drawnGoal=e?.goal,this.card.show(performance.now())}walk(){let{attempt:e,command:t,robot:n}=this.context,s=this.planner.draft?.goal;s&&e("Walk to the goal",async()=>{this.plays()||await this.orders.play(),t.mine||await t.take(),await n.order("/walk_to",{x:s.x,y:s.y,yaw:s.yaw},qT),this.planner.draft?.goal===s&&this.planner.begun()},"begun")}leave(){let{attempt:e,command:t,robot:n}=this.context;e("Leave the way",async()=>{t.mine||await t.take(),await n.order("/walk_to/cancel")})}};var Xh=class{constructor(e,t,n){this.part=e;this.show=t;this.failed=n}known;asks=!1;failed_ms=-1/0;forget(){this.known=void 0}async take(e,t){if(!(e===this.known||this.asks||t-this.failed_ms<2e3)){this.asks=!0;try{let{solids:n,floorColour:s,number:r}=await this.all();this.known=r,this.show(n,s)}catch(n){this.failed_ms=t,this.failed(n)}finally{this.asks=!1}}}async all(){let e=[],t;for(;;){let n=await this.part(e.length);if(t!==void 0&&n.geometry!==t){e.length=0,t=void 0;continue}if(t=n.geometry,e.push(...n.solids),e.length>=n.total)return{solids:e,floorColour:n.floorColour,number:t};if(n.solids.length===0)throw new Error(`the world has ${n.total} solids, of which only ${e.length} came`)}}};var YT=1.3,Cf=class{constructor(e,t){this.context=e;this.place=t;let{scene:n,canvas:s,tools:r,tabs:o}=t,a=new kh(e.robot);this.picture=new Ih(n,e.description,e.token()),this.way=new Wh(e,a,this.picture,n,s,r,()=>this.state?.state==="playing");let l=P0(e,a),c=H0(e,a,this.picture,s,r);o.add(c,l),r.add(this.way.tool,c.tool),this.bar=new zh(e,a,[Qe("Things",()=>o.open(c),{id:"open-things",title:"Put things into the world, move them"}),Qe("Faults",()=>o.open(l),{id:"open-faults",title:"Let something go wrong"})]),this.worldChanged=()=>{this.way.worldChanged(),c.worldChanged()},this.world=new Xh(h=>a.geometry(h),(h,u)=>{this.picture.setSolids(h,u),this.state&&this.picture.show(this.state,this.trail.originFor(this.state)),this.worldChanged()},h=>e.news.say(`The world is not known: ${h.message}`,"bad","world")),e.frameTakers.push(h=>this.trail.take(h)),document.body.classList.add("simulated"),ft("panel").before(this.bar.box),ft("camera").prepend(this.way.tool.toggle),ft("picture").append(this.way.card.box),document.querySelector(".legend")?.append(O("li",{class:"left-step"},"left step"),O("li",{class:"right-step"},"right step")),n.zoom(YT),this.way.tool.setOn(!0)}bar;picture;way;world;worldChanged;trail=new Fh;state;came_ms=0;take(e,t){let n=this.state!==void 0&&this.state.run!==e.run;(n||t-this.came_ms>mf||this.state?.world!==e.world)&&this.world.forget(),this.state=e,this.came_ms=t,this.context.freshness.pace=d0(e),n&&this.jumped(),this.picture.show(e,this.trail.originFor(e)),this.bar.show(e),this.world.take(e.geometry,t)}jumped(){this.context.command.lost(),this.trail.forget(),this.place.scene.forgetSteps(),this.way.jumped()}look(e){let t=e-this.came_ms>mf,{stops:n,banner:s}=this.place;t&&(this.context.freshness.pace=1),n.setSpaceStops(t),s.rests=!t&&this.state?.state!=="playing",this.bar.setSilent(t),this.way.look(e)}};function l_(i,e){let t;return i.robot.subscribe(pf.name,pf.type,0,n=>{t??=new Cf(i,e),t.take(u0(n),performance.now())}),n=>t?.look(n)}var $h=class{constructor(e){this.context=e;let{attempt:t,command:n}=e;Be(ft("robot-name"),e.description.name),document.title=`${e.description.name} – Gaitway`,this.take.addEventListener("click",()=>void t("Take the command",()=>n.take())),this.give.addEventListener("click",()=>void t("Give the command back",()=>n.giveBack()))}lamp=ft("link");lampText=ft("link-text");activity=ft("activity");commander=ft("commander");old=ft("old");take=ft("take");give=ft("give");canvas=ft("scene");look(e){let{freshness:t}=this.context,n=t.state(e);this.lamp.className=`lamp ${n}`,Be(this.lampText,this.linkText(e)),this.old.hidden=n==="live",n!=="live"&&Be(this.old,this.oldText(e));let s=n==="lost"?void 0:t.newest;s?this.showFrame(s):this.showNothing(),this.showCommand(s)}linkText(e){let{freshness:t}=this.context,n=oi(t.pictureAge_ms(e));return t.state(e)==="live"?t.rests?"paused":`live, ${n}`:t.state(e)==="old"?`old, ${n}`:"no connection"}oldText(e){let{freshness:t}=this.context;if(!t.newest)return"Nothing has come from the robot yet.";if(t.state(e)==="lost")return`Connection lost: the picture is ${oi(t.sinceCame_ms(e))} old. Trying again…`;let n=pl.filter((s,r)=>r!==3&&t.age_ms(r,e)>300);return`Old, ${oi(t.pictureAge_ms(e))}: ${n.join(", ")}.`}showNothing(){Be(this.activity,""),this.activity.classList.remove("alarm","caution"),this.canvas.setAttribute("aria-label","The robot, as it was last seen")}showFrame(e){let t=e.mode[0]??NaN,n=Jp[e.activity[0]??0]??"",s=t===vs.batches?n:`${Qp[t]??"state not known"}, ${n}`;Be(this.activity,s),this.activity.classList.toggle("alarm",t===vs.emergencyStop||(e.activity[0]??0)>=4),this.activity.classList.toggle("caution",t===vs.safeTail);let r=Math.hypot(e.velocity[0]??0,e.velocity[1]??0);this.canvas.setAttribute("aria-label",`The robot ${s}${r>.03?`, ${r.toFixed(1)} m/s`:""}`)}showCommand(e){let{command:t,robot:n}=this.context,s=e?fl(e):"",r=!t.mine&&s!=="";Be(this.commander,t.mine?"you command":r?`${s} commands`:e?"nobody commands":""),this.commander.classList.toggle("mine",t.mine),this.take.hidden=t.mine,this.take.disabled=r||!n.isOpen,this.give.hidden=!t.mine}};function c_(i,e){i.addEventListener("pointerdown",t=>t.button===0&&e()),i.addEventListener("click",e)}var qh=class{constructor(e,t){this.context=e;this.ended=t;c_(this.stopButton,()=>this.stop()),c_(this.emergencyButton,()=>this.emergencyStop()),this.releaseButton.addEventListener("click",()=>this.release()),document.addEventListener("keydown",n=>this.key(n),{capture:!0}),document.addEventListener("keyup",n=>n.code==="Space"&&!qs(n.target)&&n.preventDefault(),{capture:!0})}stopButton=ft("stop");emergencyButton=ft("emergency");releaseButton=ft("release");keys=this.stopButton.querySelector("small");spaceStops=!0;stop(){this.ended(),this.tellIfPaused(),this.context.attempt("Stop",()=>this.context.robot.stop("/stop"))}setSpaceStops(e){e!==this.spaceStops&&(this.spaceStops=e,this.stopButton.setAttribute("aria-keyshortcuts",e?"Escape Space":"Escape"),this.keys&&Be(this.keys,e?"Esc, Space":"Esc"))}show(e){let t=e.mode[0]===vs.emergencyStop;this.releaseButton.hidden=!t,this.emergencyButton.setAttribute("aria-pressed",String(t))}tellIfPaused(){this.context.freshness.pace===0&&this.context.news.say("The simulation is paused: the robot stops as soon as it plays on.","plain","stop while paused")}emergencyStop(){this.ended(),this.tellIfPaused(),this.context.attempt("Emergency stop",()=>this.context.robot.stop("/emergency_stop",{data:!1}))}release(){let{attempt:e,command:t,robot:n}=this.context;e("Release",async()=>{t.mine||await t.take(),await n.order("/release")})}key(e){let t=e.code==="Escape"||this.spaceStops&&e.code==="Space"&&!qs(e.target);if(!t||e.repeat){t&&e.preventDefault();return}e.preventDefault(),e.stopPropagation(),this.stop()}};var Yh=class{constructor(e,t,n){this.bar=e;this.panels=t;this.add(...n),e.addEventListener("keydown",s=>this.step(s,[...this.buttons.keys()])),n[0]&&this.open(n[0])}current;buttons=new Map;add(...e){for(let t of e){let n=`tab-${this.buttons.size}`,s=O("button",{type:"button",role:"tab",id:n,"aria-controls":`${n}-panel`,"aria-selected":"false",tabindex:-1},t.title);t.content.id=`${n}-panel`,t.content.setAttribute("role","tabpanel"),t.content.setAttribute("aria-labelledby",n),t.content.hidden=!0,s.addEventListener("click",()=>this.open(t)),this.buttons.set(t,s),this.bar.append(s),this.panels.append(t.content)}}look(e){this.current?.look?.(e)}open(e){if(e!==this.current){this.current?.hide?.(),this.current=e;for(let[t,n]of this.buttons){let s=t===e;n.setAttribute("aria-selected",String(s)),n.tabIndex=s?0:-1,t.content.hidden=!s}this.buttons.get(e)?.scrollIntoView({inline:"nearest",block:"nearest"}),this.panels.scrollTop=0,e.show?.(),e.look?.(performance.now())}}step(e,t){let s={ArrowRight:1,ArrowLeft:-1}[e.key];if(s===void 0||!this.current)return;e.preventDefault(),e.stopPropagation();let r=t[(t.indexOf(this.current)+s+t.length)%t.length];r&&(this.open(r),this.buttons.get(r)?.focus())}};async function h_(i,e){let t=await fetch(i,Ji(e));if(!t.ok)throw new Error(await t.text());return t.json()}var u_=i=>h_("motions.json",i),d_=(i,e)=>h_(i,e),ZT=.8;function f_(i,{period:e,postures:t}){let n=(t.length-1)*e;return Math.min(i%(n+ZT),n)}function p_({period:i,postures:e},t){let n=Math.min(Math.max(t/i,0),e.length-1),s=e[Math.floor(n)],r=e[Math.ceil(n)];if(!s||!r)throw new RangeError("a motion has no postures");let o=(a,l)=>a.map((c,h)=>c+((l[h]??c)-c)*(n-Math.floor(n)));return{joints:o(s.joints,r.joints),feet:[o(s.feet[0],r.feet[0]),o(s.feet[1],r.feet[1])],support:s.support}}function Zh({description:i,duration:e,start:t,refused:n}){if(n!==void 0)return`No preview: ${n}.`;let s=t!=="stands"?" On the ground it is drawn roughly.":"";return`${i??""} ${(e??0).toFixed(1)} s; begins when the robot ${t}.${s}`.trim()}function m_({period:i,postures:e},t){let n=e.findIndex(({support:s})=>s!==3);return n<0?0:Math.min(Math.max(t/Math.max(n*i,i),0),1)}var KT=50,JT={"lies on its front":[0,Math.PI/2],"lies on its back":[0,-Math.PI/2],"lies on its left":[-Math.PI/2,0],"lies on its right":[Math.PI/2,0]},If=class{constructor(e,t){this.canvas=e;let{description:n}=t;this.renderer=new bo({canvas:e,antialias:!0,alpha:!0,powerPreference:"low-power"}),this.body=new Us(n),yf(this.body);let s=n.hip_height*2,r=new pr(s*1.2,8,9082790,9082790);r.rotation.x=Math.PI/2;let o=new fr(16777215,2.2);o.position.set(1.5,2,4),this.scene.add(this.body.base,r,new dr(16777215,8952234,2.4),o),this.camera.up.set(0,0,1),this.camera.position.set(2*s,1.35*s,.9*s),this.camera.lookAt(0,0,s*.52),this.body.loadMeshes(t.token(),()=>{}).catch(()=>{})}renderer;scene=new rr;camera=new xn(32,1,.05,50);body;box=new zi;draw(e,t,n){this.body.pose(e.joints),e.support===3?this.layDown(t,n):this.stand(e);let{clientWidth:s,clientHeight:r}=this.canvas;this.renderer.setSize(s,r,!1),this.camera.aspect=s/Math.max(r,1),this.camera.updateProjectionMatrix(),this.renderer.render(this.scene,this.camera)}stand({feet:e,support:t}){let n=t===1?1:0,[s,r,o,a]=e[n],l=new Et().makeRotationZ(a).setPosition(s,r,o),{base:c}=this.body;c.position.set(0,0,0),c.quaternion.identity(),c.updateMatrixWorld(!0),l.multiply(this.body.solePose(n).invert()).decompose(c.position,c.quaternion,c.scale)}layDown(e,t){let{base:n}=this.body,[s,r]=JT[e]??[0,Math.PI/2];n.quaternion.setFromEuler(new Zn(s,r,0)).slerp(new en,t*t),n.position.set(0,0,0),this.box.setFromObject(n),n.position.set(-(this.box.min.x+this.box.max.x)/2,0,-this.box.min.z)}},Kh=class{constructor(e){this.context=e}canvas=O("canvas",{role:"img","aria-label":"Ghost of the robot that plays a motion"});title=O("strong");text=O("span");figure=O("figure",{class:"preview",hidden:!0},this.canvas,O("figcaption",{role:"status"},this.title," ",this.text,O("small",{},"A preview: the robot does not move.")));known=new Map;picture;shown;get name(){return this.shown?.name}async show(e){if(this.shown!==e&&(this.shown=e,this.figure.hidden=!1,this.canvas.hidden=e.postures===void 0,Be(this.title,e.name.replaceAll("_"," ")),Be(this.text,Zh(e)),e.postures!==void 0))try{let t=await this.posturesOf(e.postures);this.shown===e&&this.play(e,t)}catch(t){this.known.delete(e.postures),this.shown===e&&Be(this.text,`No preview: ${t.message}`)}}hide(){this.shown=void 0,this.figure.hidden=!0}posturesOf(e){let t=this.known.get(e)??d_(e,this.context.token());return this.known.set(e,t),t}play(e,t){this.picture??=new If(this.canvas,this.context);let n=performance.now(),s=-1/0,r=o=>{if(this.shown!==e||(requestAnimationFrame(r),o-s<KT||this.canvas.clientWidth===0))return;s=o;let a=f_(Math.max(o-n,0)/1e3,t);this.picture?.draw(p_(t,a),e.start??"",m_(t,a)),this.figure.dataset.time=a.toFixed(2)};requestAnimationFrame(r)}};var g_=i=>i.replaceAll("_"," ");function __(i,e,...t){let n=new Kh(i);ft("picture").append(n.figure);let s,r,o=async f=>{r??=u_(i.token()).then(g=>new Map(g.map(y=>[y.name,y])));try{return(await r).get(f)??{name:f,refused:"it is not prepared: run `gaitway motion prepare`"}}catch(g){return r=void 0,{name:f,refused:g.message}}},a,l=async f=>{a=f;let g=await o(f);a===f&&await n.show(g)},c=()=>{a=void 0,n.hide()},h=f=>{s?.setAttribute("aria-pressed","false"),s=f,s?.setAttribute("aria-pressed","true")},u=()=>s?void l(s.value):c(),d=f=>{let g=Qe(g_(f),()=>e(f)),y=Qe("▷",()=>{h(s===y?void 0:y),u()},{class:"show",value:f,"aria-pressed":"false","aria-label":`Preview ${g_(f)}`,title:"Preview: the robot does not move"});for(let m of[g,y])m.addEventListener("pointerenter",({pointerType:p})=>p==="mouse"&&void l(f)),m.addEventListener("pointerleave",({pointerType:p})=>p==="mouse"&&u()),m.addEventListener("focus",()=>m.matches(":focus-visible")&&void l(f)),m.addEventListener("blur",u);return g.addEventListener("pointerenter",()=>void o(f).then(m=>g.title=Zh(m)),{once:!0}),O("span",{class:"motion"},g,y)};return{group:O("div",{class:"buttons",role:"group","aria-label":"Motions"},...i.description.motions.map(d),...t),hide:()=>{h(void 0),c()}}}var Mo=i=>Number.isNaN(i)?"–":`${i<-.005?"−":""}${Math.abs(i).toFixed(2)}`;function jT(){let i=[],e=["forward, m/s","left, m/s","turn, rad/s"].map(s=>{let r=[0,1,2].map(()=>O("td",{class:"number"}));return i.push(r),O("tr",{},O("th",{scope:"row"},s),...r)}),t=O("tr",{},O("td"),...["asked","is","at most"].map(s=>O("th",{scope:"col"},s)));return{table:O("table",{class:"speeds"},O("caption",{class:"hidden"},"Speeds"),O("thead",{},t),O("tbody",{},...e)),cells:i}}var QT={rests:"Hold the stick, or W A S D: the robot walks while you hold it.",waits:"Asking for the command…",drives:"Driving. Let go, and it stands.",blocked:"Ended. Let go of the stick first."};function e1(i,e,t,n){if(n)return"The simulator is paused: the robot moves once it plays.";if(e?.mode[0]===vs.emergencyStop)return"The emergency stop holds the robot: it walks once that is released.";if(e?.activity[0]!==jp)return QT[i];let s=t.filter(r=>r.startsWith("get_up")).map(r=>`“${r.replaceAll("_"," ")}”`);return`The robot lies, and walks nowhere. ${s.length>0?`Below are ${s.join(" and ")}: the side that it lies on decides.`:"Lift it up."}`}function y_(i,e){let{attempt:t,command:n,robot:s,freshness:r,drive:o}=i,{table:a,cells:l}=jT(),c=O("p",{class:"hint",role:"status"}),h=(m,p,b)=>()=>void t(m,async()=>{n.mine||await n.take(),await p()},b),u=Qe("Stand",h("Stand",()=>s.order("/stand",{},15e3))),d=Qe("Leave the motion",h("Leave the motion",()=>s.order("/play_motion",{motion:""}))),f=__(i,m=>h(`Motion ${m}`,()=>s.order("/play_motion",{motion:m},15e3),"begun")(),d),g=O("p",{class:"hint",role:"status"}),y=O("div",{class:"drive"},O("div",{class:"sticks"},e.walk.field,O("div",{class:"beside"},e.side.field,c,u)),a,O("h2",{},"Motions"),f.group,g);return s.subscribe("/motion_state","gaitway_msgs/msg/MotionState",200,m=>{let p=m.state!=="none";d.disabled=!p;let b=p?`${m.motion}: ${m.state}, ${Number(m.time).toFixed(1)} of ${Number(m.duration).toFixed(1)} s`:"";Be(g,b||(m.result==="none"?"":`${m.motion}: ${m.result}`))}),{title:"Drive",content:y,hide:f.hide,look:()=>{Be(c,e1(o.state,r.newest,i.description.motions,r.rests));let{forward:m,left:p,turn:b}=e.sent,w=r.newest?.velocity??[],{bounds:x}=e,P=[`${Mo(-x.backward)} … ${Mo(x.forward)}`,`± ${Mo(x.left)}`,`± ${Mo(x.turn)}`];for(let[A,D]of[m,p,b].entries()){let F=[Mo(D),Mo(w[A]??NaN),P[A]??""];for(let[T,S]of(l[A]??[]).entries())Be(S,F[T]??"")}}}}var x_=500,t1=[{least:0,name:"all"},{least:30,name:"warnings and errors"},{least:40,name:"errors"}];function n1(i){let e=i.stamp;return{time_s:e.sec+e.nanosec*1e-9,level:Number(i.level),source:String(i.name),text:String(i.msg)}}function i1(i,e,t){let n=`${i.source} ${i.text}`.toLowerCase();return i.level>=e&&t.toLowerCase().split(/\s+/).every(s=>n.includes(s))}function v_({time_s:i,level:e,source:t,text:n}){let s=e>=40?"error":e>=30?"warning":"info";return O("li",{class:s},O("span",{class:"number"},i.toFixed(2))," ",O("b",{},s==="info"?t:`${s}: ${t}`),` ${n}`)}function b_({robot:i}){let e=[],t=O("ol",{class:"events",tabindex:0,"aria-label":"Events, the newest first"}),n=O("select",{id:"event-level","aria-label":"Which events"},...t1.map(({least:h,name:u})=>O("option",{value:h},u))),s=O("input",{type:"search",placeholder:"filter by words","aria-label":"Filter by words"}),r=h=>i1(h,Number(n.value),s.value),o=O("p",{class:"hint",role:"status"}),a=()=>Be(o,t.childElementCount>0?"":e.length>0?`None of ${e.length} events passes the filter.`:"No event yet."),l=()=>{t.replaceChildren(...e.filter(r).map(v_)),a()};n.addEventListener("change",l),s.addEventListener("input",l),i.subscribe("/events","rcl_interfaces/msg/Log",0,h=>{let u=n1(h);for(e=[u,...e.slice(0,x_-1)],r(u)&&t.prepend(v_(u));t.childElementCount>x_;)t.lastElementChild?.remove();a()}),a();let c=Qe("Clear",()=>{e=[],l()});return{title:"Events",content:O("div",{class:"events-tab"},O("div",{class:"tools"},n,s,c),o,t)}}var s1="uplot",r1="u-hz",o1="u-vt",a1="u-title",l1="u-wrap",c1="u-under",h1="u-over",u1="u-axis",Tr="u-off",d1="u-select",f1="u-cursor-x",p1="u-cursor-y",m1="u-cursor-pt",g1="u-legend",_1="u-live",y1="u-inline",x1="u-series",v1="u-marker",w_="u-label",b1="u-value",qa="width",Ya="height";var M_="bottom",So="left",Lf="right",Zf="#000",S_=Zf+"0",Df="mousemove",E_="mousedown",Nf="mouseup",T_="mouseenter",A_="mouseleave",R_="dblclick",w1="resize",M1="scroll",C_="change",tu="dppxchange",Kf="--",Io=typeof window<"u",Bf=Io?document:null,To=Io?window:null,S1=Io?navigator:null,St,Jh;function zf(){let i=devicePixelRatio;St!=i&&(St=i,Jh&&Vf(C_,Jh,zf),Jh=matchMedia(`(min-resolution: ${St-.001}dppx) and (max-resolution: ${St+.001}dppx)`),Ar(C_,Jh,zf),To.dispatchEvent(new CustomEvent(tu)))}function Qn(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Hf(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Yt(i,e,t){i.style[e]=t+"px"}function Ri(i,e,t,n){let s=Bf.createElement(i);return e!=null&&Qn(s,e),t?.insertBefore(s,n),s}function di(i,e){return Ri("div",i,e)}var P_=new WeakMap;function qi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=P_.get(i);r!=o&&(i.style.transform=r,P_.set(i,r),e<0||t<0||e>n||t>s?Qn(i,Tr):Hf(i,Tr))}var I_=new WeakMap;function L_(i,e,t){let n=e+t,s=I_.get(i);n!=s&&(I_.set(i,n),i.style.background=e,i.style.borderColor=t)}var D_=new WeakMap;function N_(i,e,t,n){let s=e+""+t,r=D_.get(i);s!=r&&(D_.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Jf={passive:!0},E1={...Jf,capture:!0};function Ar(i,e,t,n){e.addEventListener(i,t,n?E1:Jf)}function Vf(i,e,t,n){e.removeEventListener(i,t,Jf)}Io&&zf();function Ci(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ei((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function ly(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var cy=i=>i!=null,hy=i=>i!=null&&i>0,su=ly(cy),T1=ly(hy);function A1(i,e,t,n=0,s=!1){let r=s?T1:su,o=s?hy:cy;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??kt,l??-kt]}function ru(i,e,t,n){let s=U_(i),r=U_(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?us:uy,a=s==1?ei:fi,l=r==1?fi:ei,c=a(o(un(i))),h=l(o(un(e))),u=Ao(t,c),d=Ao(t,h);return t==10&&(c<0&&(u=Ft(u,-c)),h<0&&(d=Ft(d,-h))),n||t==2?(i=u*s,e=d*r):(i=my(i,u),e=ou(e,d)),[i,e]}function jf(i,e,t,n){let s=ru(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Qf=.1,k_={mode:3,pad:Qf},Ka={pad:0,soft:null,mode:0},R1={min:Ka,max:Ka};function nu(i,e,t,n){return au(t)?F_(i,e,t):(Ka.pad=t,Ka.soft=n?0:null,Ka.mode=n?3:0,F_(i,e,R1))}function bt(i,e){return i??e}function C1(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function F_(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),o=bt(s.pad,0),a=bt(n.hard,-kt),l=bt(s.hard,kt),c=bt(n.soft,kt),h=bt(s.soft,-kt),u=bt(n.mode,0),d=bt(s.mode,0),f=e-i,g=us(f),y=Un(un(i),un(e)),m=us(y),p=un(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,u==2&&c!=kt&&(r=0),d==2&&h!=-kt&&(o=0)));let b=f||y||1e3,w=us(b),x=Ao(10,ei(w)),P=b*(f==0?i==0?.1:1:r),A=Ft(my(i-P,x/10),24),D=i>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:kt,F=Un(a,A<D&&i>=D?D:Pi(D,A)),T=b*(f==0?e==0?.1:1:o),S=Ft(ou(e+T,x/10),24),R=e<=h&&(d==1||d==3&&S>=h||d==2&&S<=h)?h:-kt,B=Pi(l,S>R&&e<=R?R:Un(R,S));return F==B&&F==0&&(B=100),[F,B]}var P1=new Intl.NumberFormat(Io?S1.language:"en-US"),ep=i=>P1.format(i),ti=Math,eu=ti.PI,un=ti.abs,ei=ti.floor,hn=ti.round,fi=ti.ceil,Pi=ti.min,Un=ti.max,Ao=ti.pow,U_=ti.sign,us=ti.log10,uy=ti.log2,I1=(i,e=1)=>ti.sinh(i)*e,kf=(i,e=1)=>ti.asinh(i/e),kt=1/0;function O_(i){return(us((i^i>>31)-(i>>31))|0)+1}function Gf(i,e,t){return Pi(Un(i,e),t)}function dy(i){return typeof i=="function"}function pt(i){return dy(i)?i:()=>i}var L1=()=>{},fy=i=>i,py=(i,e)=>e,D1=i=>null,B_=i=>!0,z_=(i,e)=>i==e,N1=/\.\d*?(?=9{6,}|0{6,})/gm,Rr=i=>{if(_y(i)||Bs.has(i))return i;let e=`${i}`,t=e.match(N1);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Rr(s)}e${r}`}return Ft(i,n)};function Sr(i,e){return Rr(Ft(Rr(i/e))*e)}function ou(i,e){return Rr(fi(Rr(i/e))*e)}function my(i,e){return Rr(ei(Rr(i/e))*e)}function Ft(i,e=0){if(_y(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return hn(n)/t}var Bs=new Map;function gy(i){return((""+i).split(".")[1]||"").length}function ja(i,e,t,n){let s=[],r=n.map(gy);for(let o=e;o<t;o++){let a=un(o),l=Ft(Ao(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ft(h,u);s.push(d),Bs.set(d,u)}}return s}var Ja={},tp=[],Ro=[null,null],Os=Array.isArray,_y=Number.isInteger,k1=i=>i===void 0;function H_(i){return typeof i=="string"}function au(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function F1(i){return i!=null&&typeof i=="object"}var U1=Object.getPrototypeOf(Uint8Array),yy="__proto__";function Co(i,e=au){let t;if(Os(i)){let n=i.find(s=>s!=null);if(Os(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Co(i[s],e)}else t=i.slice()}else if(i instanceof U1)t=i.slice();else if(e(i)){t={};for(let n in i)n!=yy&&(t[n]=Co(i[n],e))}else t=i;return t}function sn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=yy&&(au(i[s])?sn(i[s],Co(n[s])):i[s]=Co(n[s]))}return i}var O1=0,B1=1,z1=2;function H1(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function V1(i,e){if(X1(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return $1(o[0])||(o=W1(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:B1,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(l[g]);y===null?d!=O1&&(u[m]=y,d==z1&&f.push(m)):u[m]=y}H1(u,f,s),n.push(u)}}return n}var G1=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function W1(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function X1(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function $1(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Un(1,ei((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var xy=["January","February","March","April","May","June","July","August","September","October","November","December"],vy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function by(i){return i.slice(0,3)}var q1=vy.map(by),Y1=xy.map(by),Z1={MMMM:xy,MMM:Y1,WWWW:vy,WWW:q1};function $a(i){return(i<10?"0":"")+i}function K1(i){return(i<10?"00":i<100?"0":"")+i}var J1={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>$a(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>$a(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>$a(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>$a(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>$a(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>K1(i.getMilliseconds())};function np(i,e){e=e||Z1;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?J1[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var j1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Q1(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==j1?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var wy=i=>i%1==0,iu=[1,2,2.5,5],eA=ja(10,-32,0,iu),My=ja(10,0,32,iu),tA=My.filter(wy),Er=eA.concat(My),ip=`
`,Sy="{YYYY}",V_=ip+Sy,Ey="{M}/{D}",Za=ip+Ey,jh=Za+"/{YY}",Ty="{aa}",nA="{h}:{mm}",Eo=nA+Ty,G_=ip+Eo,W_=":{ss}",Tt=null;function Ay(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?ja(10,0,3,iu).filter(wy):ja(10,-3,0,iu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Sy,Tt,Tt,Tt,Tt,Tt,Tt,1],[s*28,"{MMM}",V_,Tt,Tt,Tt,Tt,Tt,1],[s,Ey,V_,Tt,Tt,Tt,Tt,Tt,1],[n,"{h}"+Ty,jh,Tt,Za,Tt,Tt,Tt,1],[t,Eo,jh,Tt,Za,Tt,Tt,Tt,1],[e,W_,jh+" "+Eo,Tt,Za+" "+Eo,Tt,G_,Tt,1],[i,W_+".{fff}",jh+" "+Eo,Tt,Za+" "+Eo,Tt,G_,Tt,1]];function h(u){return(d,f,g,y,m,p)=>{let b=[],w=m>=o,x=m>=r&&m<o,P=u(g),A=Ft(P*i,3),D=Ff(P.getFullYear(),w?0:P.getMonth(),x||w?1:P.getDate()),F=Ft(D*i,3);if(x||w){let T=x?m/r:0,S=w?m/o:0,R=A==F?A:Ft(Ff(D.getFullYear()+S,D.getMonth()+T,1)*i,3),B=new Date(hn(R/i)),V=B.getFullYear(),X=B.getMonth();for(let $=0;R<=y;$++){let q=Ff(V+S*$,X+T*$,1),Q=q-u(Ft(q*i,3));R=Ft((+q+Q)*i,3),R<=y&&b.push(R)}}else{let T=m>=s?s:m,S=ei(g)-ei(A),R=F+S+ou(A-F,T);b.push(R);let B=u(R),V=B.getHours()+B.getMinutes()/t+B.getSeconds()/n,X=m/n,$=d.axes[f]._space,q=p/$;for(;R=Ft(R+m,i==1?0:3),!(R>y);)if(X>1){let Q=ei(Ft(V+X,6))%24,le=u(R).getHours()-Q;le>1&&(le=-1),R-=le*n,V=(V+X)%24;let ye=b[b.length-1];Ft((R-ye)/m,3)*q>=.7&&b.push(R)}else b.push(R)}return b}}return[l,c,h]}var[iA,sA,rA]=Ay(1),[oA,aA,lA]=Ay(.001);ja(2,-53,53,[1]);function X_(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function $_(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,f;return n.map(g=>{let y=i(g),m=y.getFullYear(),p=y.getMonth(),b=y.getDate(),w=y.getHours(),x=y.getMinutes(),P=y.getSeconds(),A=m!=l&&a[2]||p!=c&&a[3]||b!=h&&a[4]||w!=u&&a[5]||x!=d&&a[6]||P!=f&&a[7]||a[1];return l=m,c=p,h=b,u=w,d=x,f=P,A(y)})}}function cA(i,e){let t=np(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Ff(i,e,t){return new Date(i,e,t)}function q_(i,e){return e(i)}var hA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Y_(i,e){return(t,n,s,r)=>r==null?Kf:e(i(n))}function uA(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function dA(i,e){return i.series[e].fill(i,e)}var fA={show:!0,live:!0,isolate:!1,mount:L1,markers:{show:!0,width:2,stroke:uA,fill:dA,dash:"solid"},idx:null,idxs:null,values:[]};function pA(i,e){let t=i.cursor.points,n=di(),s=t.size(i,e);Yt(n,qa,s),Yt(n,Ya,s);let r=s/-2;Yt(n,"marginLeft",r),Yt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Yt(n,"borderWidth",o),n}function mA(i,e){let t=i.series[e].points;return t._fill||t._stroke}function gA(i,e){let t=i.series[e].points;return t._stroke||t._fill}function _A(i,e){return i.series[e].points.size}var Uf=[0,0];function yA(i,e,t){return Uf[0]=e,Uf[1]=t,Uf}function Qh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Of(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var xA={show:!0,x:!0,y:!0,lock:!1,move:yA,points:{one:!1,show:pA,size:_A,width:0,stroke:gA,fill:mA},bind:{mousedown:Qh,mouseup:Qh,click:Qh,dblclick:Qh,mousemove:Of,mouseleave:Of,mouseenter:Of},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Ry={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sp=sn({},Ry,{filter:py}),Cy=sn({},sp,{size:10}),Py=sn({},Ry,{show:!1}),rp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Iy="bold "+rp,Ly=1.5,Z_={show:!0,scale:"x",stroke:Zf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Iy,side:2,grid:sp,ticks:Cy,border:Py,font:rp,lineGap:Ly,rotate:0},vA="Value",bA="Time",K_={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function wA(i,e,t,n,s){return e.map(r=>r==null?"":ep(r))}function MA(i,e,t,n,s,r,o){let a=[],l=Bs.get(s)||0;t=o?t:Ft(ou(t,s),l);for(let c=t;c<=n;c=Ft(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Wf(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?us:uy,h=ei(c(t));s=Ao(l,h),l==10&&(s=Er[Ci(s,Er)]);let u=t,d=s*l;l==10&&(d=Er[Ci(d,Er)]);do a.push(u),u=u+s,l==10&&!Bs.has(u)&&(u=Ft(u,Bs.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Er[Ci(d,Er)]));while(u<=n);return a}function SA(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Wf(i,e,Un(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Wf(i,e,Un(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var Dy=/./,EA=/[12357]/,TA=/[125]/,J_=/1/,Xf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function AA(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Dy:l(7,o)-h>=c?EA:l(5,o)-h>=c?TA:J_;if(u==J_){let d=un(l(1,o)-h);if(d<c)return Xf(e.slice().reverse(),a.distr,u,fi(c/d)).reverse()}return Xf(e,a.distr,u,1)}function RA(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=un(l(1,o)-l(2,o));return c<a?Xf(e.slice().reverse(),3,Dy,fi(a/c)).reverse():e}function CA(i,e,t,n){return n==null?Kf:e==null?"":ep(e)}var j_={show:!0,scale:"y",stroke:Zf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Iy,side:3,grid:sp,ticks:Cy,border:Py,font:rp,lineGap:Ly,rotate:0};function PA(i,e){let t=3+(i||1)*2;return Ft(t*e,3)}function IA(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=un(o-r),l=i.series[e],c=a/(l.points.space*St);return n[1]-n[0]<=c}var Q_={scale:null,auto:!0,sorted:0,min:kt,max:-kt},Ny=(i,e,t,n,s)=>s,ey={show:!0,auto:!0,sorted:0,gaps:Ny,alpha:1,facets:[sn({},Q_,{scale:"x"}),sn({},Q_,{scale:"y"})]},ty={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ny,alpha:1,points:{show:IA,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function LA(i,e,t,n,s){return t/10}var ky={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},DA=sn({},ky,{time:!1,ori:1}),ny={};function Fy(i,e){let t=ny[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(ny[i]=t)),t}var Po=1,$f=2;function Cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,y=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,p,d,f,g,y,cu,Lo,uu,Oy,zy):t(s,l,c,h,u,p,m,f,d,y,g,hu,Do,lp,By,Hy)}function op(i,e){let t=0,n=0,s=bt(i.bands,tp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function NA(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ds(i,e,t,n,s,r){return Cr(i,e,(o,a,l,c,h,u,d,f,g,y,m)=>{let p=o.pxRound,b=c.dir*(c.ori==0?1:-1),w=c.ori==0?Lo:Do,x,P;b==1?(x=t,P=n):(x=n,P=t);let A=p(u(a[x],c,y,f)),D=p(d(l[x],h,m,g)),F=p(u(a[P],c,y,f)),T=p(d(r==1?h.max:h.min,h,m,g)),S=new Path2D(s);return w(S,F,T),w(S,A,T),w(S,A,D),S})}function lu(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?uu:lp,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function kA(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function ap(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[u]),g=d==u?f:r(i[d]),y=u-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function iy(i){return i==0?fy:i==1?hn:e=>Sr(e,i)}function Uy(i){let e=i==0?cu:hu,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Pi(c,a/2,l/2),h=Pi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var cu=(i,e,t)=>{i.moveTo(e,t)},hu=(i,e,t)=>{i.moveTo(t,e)},Lo=(i,e,t)=>{i.lineTo(e,t)},Do=(i,e,t)=>{i.lineTo(t,e)},uu=Uy(0),lp=Uy(1),Oy=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},By=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},zy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Hy=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Vy(i){return(e,t,n,s,r)=>Cr(e,t,(o,a,l,c,h,u,d,f,g,y,m)=>{let{pxRound:p,points:b}=o,w,x;c.ori==0?(w=cu,x=Oy):(w=hu,x=By);let P=Ft(b.width*St,3),A=(b.size-b.width)/2*St,D=Ft(A*2,3),F=new Path2D,T=new Path2D,{left:S,top:R,width:B,height:V}=e.bbox;uu(T,S-D,R-D,B+D*2,V+D*2);let X=$=>{if(l[$]!=null){let q=p(u(a[$],c,y,f)),Q=p(d(l[$],h,m,g));w(F,q+A,Q),x(F,q,Q,A,0,eu*2)}};if(r)r.forEach(X);else for(let $=n;$<=s;$++)X($);return{stroke:P>0?F:null,fill:F,clip:T,flags:Po|$f}})}function Gy(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var FA=Gy(Lo),UA=Gy(Do);function Wy(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>Cr(t,n,(o,a,l,c,h,u,d,f,g,y,m)=>{[s,r]=su(l,s,r);let p=o.pxRound,b=V=>p(u(V,c,y,f)),w=V=>p(d(V,h,m,g)),x,P;c.ori==0?(x=Lo,P=FA):(x=Do,P=UA);let A=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Po},F=D.stroke,T=!1;if(r-s>=y*4){let V=_e=>t.posToVal(_e,c.key,!0),X=null,$=null,q,Q,Z,ae=b(a[A==1?s:r]),le=b(a[s]),ye=b(a[r]),we=V(A==1?le+1:ye-1);for(let _e=A==1?s:r;_e>=s&&_e<=r;_e+=A){let st=a[_e],ee=(A==1?st<we:st>we)?ae:b(st),ne=l[_e];ee==ae?ne!=null?(Q=ne,X==null?(x(F,ee,w(Q)),q=X=$=Q):Q<X?X=Q:Q>$&&($=Q)):ne===null&&(T=!0):(X!=null&&P(F,ae,w(X),w($),w(q),w(Q)),ne!=null?(Q=ne,x(F,ee,w(Q)),X=$=q=Q):(X=$=null,ne===null&&(T=!0)),ae=ee,we=V(ae+A))}X!=null&&X!=$&&Z!=ae&&P(F,ae,w(X),w($),w(q),w(Q))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let X=l[V];X===null?T=!0:X!=null&&x(F,b(a[V]),w(X))}let[R,B]=op(t,n);if(o.fill!=null||R!=0){let V=D.fill=new Path2D(F),X=o.fillTo(t,n,o.min,o.max,R),$=w(X),q=b(a[s]),Q=b(a[r]);A==-1&&([Q,q]=[q,Q]),x(V,Q,$),x(V,q,$)}if(!o.spanGaps){let V=[];T&&V.push(...ap(a,l,s,r,A,b,e)),D.gaps=V=o.gaps(t,n,s,r,V),D.clip=lu(V,c.ori,f,g,y,m)}return B!=0&&(D.band=B==2?[ds(t,n,s,r,F,-1),ds(t,n,s,r,F,1)]:ds(t,n,s,r,F,B)),D})}function OA(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,o,a,l)=>Cr(r,o,(c,h,u,d,f,g,y,m,p,b,w)=>{[a,l]=su(u,a,l);let x=c.pxRound,{left:P,width:A}=r.bbox,D=le=>x(g(le,d,b,m)),F=le=>x(y(le,f,w,p)),T=d.ori==0?Lo:Do,S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Po},R=S.stroke,B=d.dir*(d.ori==0?1:-1),V=F(u[B==1?a:l]),X=D(h[B==1?a:l]),$=X,q=X;s&&e==-1&&(q=P,T(R,q,V)),T(R,X,V);for(let le=B==1?a:l;le>=a&&le<=l;le+=B){let ye=u[le];if(ye==null)continue;let we=D(h[le]),_e=F(ye);e==1?T(R,we,V):T(R,$,_e),T(R,we,_e),V=_e,$=we}let Q=$;s&&e==1&&(Q=P+A,T(R,Q,V));let[Z,ae]=op(r,o);if(c.fill!=null||Z!=0){let le=S.fill=new Path2D(R),ye=c.fillTo(r,o,c.min,c.max,Z),we=F(ye);T(le,Q,we),T(le,q,we)}if(!c.spanGaps){let le=[];le.push(...ap(h,u,a,l,B,D,n));let ye=c.width*St/2,we=t||e==1?ye:-ye,_e=t||e==-1?-ye:ye;le.forEach(st=>{st[0]+=we,st[1]+=_e}),S.gaps=le=c.gaps(r,o,a,l,le),S.clip=lu(le,d.ori,m,p,b,w)}return ae!=0&&(S.band=ae==2?[ds(r,o,a,l,R,-1),ds(r,o,a,l,R,1)]:ds(r,o,a,l,R,ae)),S})}function sy(i,e,t,n,s,r,o=kt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=un(i[l]-i[a]);h<c&&(c=h,o=un(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function BA(i){i=i||Ja;let e=bt(i.size,[.6,kt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=pt(s),o=1-e[0],a=bt(e[1],kt),l=bt(e[2],1),c=bt(i.disp,Ja),h=bt(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,g,y,m)=>Cr(f,g,(p,b,w,x,P,A,D,F,T,S,R)=>{let B=p.pxRound,V=t,X=n*St,$=a*St,q=l*St,Q,Z;x.ori==0?[Q,Z]=r(f,g):[Z,Q]=r(f,g);let ae=x.dir*(x.ori==0?1:-1),le=x.ori==0?uu:lp,ye=x.ori==0?h:(k,J,ie,te,Fe,ue,Le)=>{h(k,J,ie,Fe,te,Le,ue)},we=bt(f.bands,tp).find(k=>k.series[0]==g),_e=we!=null?we.dir:0,st=p.fillTo(f,g,p.min,p.max,_e),et=B(D(st,P,R,T)),ee,ne,Ee,He=S,xe=B(p.width*St),tt=!1,Ut=null,N=null,gt=null,Ke=null;u!=null&&(xe==0||d!=null)&&(tt=!0,Ut=u.values(f,g,y,m),N=new Map,new Set(Ut).forEach(k=>{k!=null&&N.set(k,new Path2D)}),xe>0&&(gt=d.values(f,g,y,m),Ke=new Map,new Set(gt).forEach(k=>{k!=null&&Ke.set(k,new Path2D)})));let{x0:Xe,size:ke}=c;if(Xe!=null&&ke!=null){V=1,b=Xe.values(f,g,y,m),Xe.unit==2&&(b=b.map(ie=>f.posToVal(F+ie*S,x.key,!0)));let k=ke.values(f,g,y,m);ke.unit==2?ne=k[0]*S:ne=A(k[0],x,S,F)-A(0,x,S,F),He=sy(b,w,A,x,S,F,He),Ee=He-ne+X}else He=sy(b,w,A,x,S,F,He),Ee=He*o+X,ne=He-Ee;Ee<1&&(Ee=0),xe>=ne/2&&(xe=0),Ee<5&&(B=fy);let At=Ee>0,Pe=He-Ee-(At?xe:0);ne=B(Gf(Pe,q,$)),ee=(V==0?ne/2:V==ae?0:ne)-V*ae*((V==0?X/2:0)+(At?xe/2:0));let We={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Gt=tt?null:new Path2D,wt=null;if(we!=null)wt=f.data[we.series[1]];else{let{y0:k,y1:J}=c;k!=null&&J!=null&&(w=J.values(f,g,y,m),wt=k.values(f,g,y,m))}let I=Q*ne,v=Z*ne;for(let k=ae==1?y:m;k>=y&&k<=m;k+=ae){let J=w[k];if(J==null)continue;if(wt!=null){let ge=wt[k]??0;if(J-ge==0)continue;et=D(ge,P,R,T)}let ie=x.distr!=2||c!=null?b[k]:k,te=A(ie,x,S,F),Fe=D(bt(J,st),P,R,T),ue=B(te-ee),Le=B(Un(Fe,et)),Re=B(Pi(Fe,et)),oe=Le-Re;if(J!=null){let ge=J<0?v:I,ze=J<0?I:v;tt?(xe>0&&gt[k]!=null&&le(Ke.get(gt[k]),ue,Re+ei(xe/2),ne,Un(0,oe-xe),ge,ze),Ut[k]!=null&&le(N.get(Ut[k]),ue,Re+ei(xe/2),ne,Un(0,oe-xe),ge,ze)):le(Gt,ue,Re+ei(xe/2),ne,Un(0,oe-xe),ge,ze),ye(f,g,k,ue-xe/2,Re,ne+xe,oe)}}return xe>0?We.stroke=tt?Ke:Gt:tt||(We._fill=p.width==0?p._fill:p._stroke??p._fill,We.width=0),We.fill=tt?N:Gt,We})}function zA(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,o)=>Cr(n,s,(a,l,c,h,u,d,f,g,y,m,p)=>{[r,o]=su(c,r,o);let b=a.pxRound,w=Q=>b(d(Q,h,m,g)),x=Q=>b(f(Q,u,p,y)),P,A,D;h.ori==0?(P=cu,D=Lo,A=zy):(P=hu,D=Do,A=Hy);let F=h.dir*(h.ori==0?1:-1),T=w(l[F==1?r:o]),S=T,R=[],B=[];for(let Q=F==1?r:o;Q>=r&&Q<=o;Q+=F)if(c[Q]!=null){let ae=l[Q],le=w(ae);R.push(S=le),B.push(x(c[Q]))}let V={stroke:i(R,B,P,D,A,b),fill:null,clip:null,band:null,gaps:null,flags:Po},X=V.stroke,[$,q]=op(n,s);if(a.fill!=null||$!=0){let Q=V.fill=new Path2D(X),Z=a.fillTo(n,s,a.min,a.max,$),ae=x(Z);D(Q,S,ae),D(Q,T,ae)}if(!a.spanGaps){let Q=[];Q.push(...ap(l,c,r,o,F,w,t)),V.gaps=Q=a.gaps(n,s,r,o,Q),V.clip=lu(Q,h.ori,g,y,m,p)}return q!=0&&(V.band=q==2?[ds(n,s,r,o,X,-1),ds(n,s,r,o,X,1)]:ds(n,s,r,o,X,q)),V})}function HA(i){return zA(VA,i)}function VA(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var qf=new Set;function ry(){for(let i of qf)i.syncRect(!0)}Io&&(Ar(w1,To,ry),Ar(M1,To,ry,!0),Ar(tu,To,()=>{Mn.pxRatio=St}));var GA=Wy(),WA=Vy();function oy(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yf(r,o,e,t))}function XA(i,e){return i.map((t,n)=>n==0?{}:sn({},e,t))}function Yf(i,e,t,n){return sn({},e==0?t:n,i)}function Xy(i,e,t){return e==null?Ro:[e,t]}var $A=Xy;function qA(i,e,t){return e==null?Ro:nu(e,t,Qf,!0)}function $y(i,e,t,n){return e==null?Ro:ru(e,t,i.scales[n].log,!1)}var YA=$y;function qy(i,e,t,n){return e==null?Ro:jf(e,t,i.scales[n].log,!1)}var ZA=qy;function KA(i,e,t,n,s){let r=Un(O_(i),O_(e)),o=e-i,a=Ci(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Bs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function ay(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=hn((t=+s)*St))+"px"),[i,e,t]}function JA(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ft(e[2]*St,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Mn(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(_,M,C,L){let H=M.valToPct(_);return L+C*(M.dir==-1?1-H:H)}function o(_,M,C,L){let H=M.valToPct(_);return L+C*(M.dir==-1?H:1-H)}function a(_,M,C,L){return M.ori==0?r(_,M,C,L):o(_,M,C,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=di(s1);if(i.id!=null&&(c.id=i.id),Qn(c,i.class),i.title){let _=di(a1,c);_.textContent=i.title}let h=Ri("canvas"),u=n.ctx=h.getContext("2d"),d=di(l1,c);Ar("click",d,_=>{_.target===g&&(Wt!=kr||Zt!=Fr)&&bn.click(n,_)},!0);let f=n.under=di(c1,d);d.appendChild(h);let g=n.over=di(h1,d);i=Co(i);let y=+bt(i.pxAlign,1),m=iy(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,b=n.series=s==1?oy(i.series||[],K_,ty,!1):XA(i.series||[null],ey),w=n.axes=oy(i.axes||[],Z_,j_,!0),x=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=pt(_.fill||null),_.dir=bt(_.dir,-1)});let A=s==2?b[1].facets[0].scale:b[0].scale,D={axes:xx,series:Gs},F=(i.drawOrder||["axes","series"]).map(_=>D[_]);function T(_){let M=_.distr==3?C=>us(C>0?C:_.clamp(n,C,_.min,_.max,_.key)):_.distr==4?C=>kf(C,_.asinh):_.distr==100?C=>_.fwd(C):C=>C;return C=>{let L=M(C),{_min:H,_max:Y}=_,se=Y-H;return(L-H)/se}}function S(_){let M=x[_];if(M==null){let C=(i.scales||Ja)[_]||Ja;if(C.from!=null){S(C.from);let L=sn({},x[C.from],C,{key:_});L.valToPct=T(L),x[_]=L}else{M=x[_]=sn({},_==A?ky:DA,C),M.key=_;let L=M.time,H=M.range,Y=Os(H);if((_!=A||s==2&&!L)&&(Y&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?k_:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?k_:{mode:1,hard:H[1],soft:H[1]}},Y=!1),!Y&&au(H))){let se=H;H=(ce,me,Ae)=>me==null?Ro:nu(me,Ae,se)}M.range=pt(H||(L?$A:_==A?M.distr==3?YA:M.distr==4?ZA:Xy:M.distr==3?$y:M.distr==4?qy:qA)),M.auto=pt(Y?!1:M.auto),M.clamp=pt(M.clamp||LA),M._min=M._max=null,M.valToPct=T(M)}}}S("x"),S("y"),s==1&&b.forEach(_=>{S(_.scale)}),w.forEach(_=>{S(_.scale)});for(let _ in i.scales)S(_);let R=x[A],B=R.distr,V,X;R.ori==0?(Qn(c,r1),V=r,X=o):(Qn(c,o1),V=o,X=r);let $={};for(let _ in x){let M=x[_];(M.min!=null||M.max!=null)&&($[_]={min:M.min,max:M.max},M.min=M.max=null)}let q=i.tzDate||(_=>new Date(hn(_/p))),Q=i.fmtDate||np,Z=p==1?rA(q):lA(q),ae=$_(q,X_(p==1?sA:aA,Q)),le=Y_(q,q_(hA,Q)),ye=[],we=n.legend=sn({},fA,i.legend),_e=n.cursor=sn({},xA,{drag:{y:s==2}},i.cursor),st=we.show,et=_e.show,ee=we.markers;we.idxs=ye,ee.width=pt(ee.width),ee.dash=pt(ee.dash),ee.stroke=pt(ee.stroke),ee.fill=pt(ee.fill);let ne,Ee,He,xe=[],tt=[],Ut,N=!1,gt={};if(we.live){let _=b[1]?b[1].values:null;N=_!=null,Ut=N?_(n,1,0):{_:0};for(let M in Ut)gt[M]=Kf}if(st)if(ne=Ri("table",g1,c),He=Ri("tbody",null,ne),we.mount(n,ne),N){Ee=Ri("thead",null,ne,He);let _=Ri("tr",null,Ee);Ri("th",null,_);for(var Ke in Ut)Ri("th",w_,_).textContent=Ke}else Qn(ne,y1),we.live&&Qn(ne,_1);let Xe={show:!0},ke={show:!1};function At(_,M){if(M==0&&(N||!we.live||s==2))return Ro;let C=[],L=Ri("tr",x1,He,He.childNodes[M]);Qn(L,_.class),_.show||Qn(L,Tr);let H=Ri("th",null,L);if(ee.show){let ce=di(v1,H);if(M>0){let me=ee.width(n,M);me&&(ce.style.border=me+"px "+ee.dash(n,M)+" "+ee.stroke(n,M)),ce.style.background=ee.fill(n,M)}}let Y=di(w_,H);_.label instanceof HTMLElement?Y.appendChild(_.label):Y.textContent=_.label,M>0&&(ee.show||(Y.style.color=_.width>0?ee.stroke(n,M):ee.fill(n,M)),We("click",H,ce=>{if(_e._lock)return;vn(ce);let me=b.indexOf(_);if((ce.ctrlKey||ce.metaKey)!=we.isolate){let Ae=b.some((Ce,Ne)=>Ne>0&&Ne!=me&&Ce.show);b.forEach((Ce,Ne)=>{Ne>0&&Di(Ne,Ae?Ne==me?Xe:ke:Xe,!0,tn.setSeries)})}else Di(me,{show:!_.show},!0,tn.setSeries)},!1),On&&We(T_,H,ce=>{_e._lock||(vn(ce),Di(b.indexOf(_),Or,!0,tn.setSeries))},!1));for(var se in Ut){let ce=Ri("td",b1,L);ce.textContent="--",C.push(ce)}return[L,C]}let Pe=new Map;function We(_,M,C,L=!0){let H=Pe.get(M)||{},Y=_e.bind[_](n,M,C,L);Y&&(Ar(_,M,H[_]=Y),Pe.set(M,H))}function Gt(_,M,C){let L=Pe.get(M)||{};for(let H in L)(_==null||H==_)&&(Vf(H,M,L[H]),delete L[H]);_==null&&Pe.delete(M)}let wt=0,I=0,v=0,k=0,J=0,ie=0,te=J,Fe=ie,ue=v,Le=k,Re=0,oe=0,ge=0,ze=0;n.bbox={};let Oe=!1,ve=!1,je=!1,z=!1,de=!1,pe=!1;function Ie(_,M,C){(C||_!=n.width||M!=n.height)&&he(_,M),Ir(!1),je=!0,ve=!0,Lr()}function he(_,M){n.width=wt=v=_,n.height=I=k=M,J=ie=0,Pt(),yt();let C=n.bbox;Re=C.left=Sr(J*St,.5),oe=C.top=Sr(ie*St,.5),ge=C.width=Sr(v*St,.5),ze=C.height=Sr(k*St,.5)}let re=3;function Ue(){let _=!1,M=0;for(;!_;){M++;let C=_x(M),L=yx(M);_=M==re||C&&L,_||(he(n.width,n.height),ve=!0)}}function nt({width:_,height:M}){Ie(_,M)}n.setSize=nt;function Pt(){let _=!1,M=!1,C=!1,L=!1;w.forEach((H,Y)=>{if(H.show&&H._show){let{side:se,_size:ce}=H,me=se%2,Ae=H.label!=null?H.labelSize:0,Ce=ce+Ae;Ce>0&&(me?(v-=Ce,se==3?(J+=Ce,L=!0):C=!0):(k-=Ce,se==0?(ie+=Ce,_=!0):M=!0))}}),Zi[0]=_,Zi[1]=C,Zi[2]=M,Zi[3]=L,v-=Li[1]+Li[3],J+=Li[3],k-=Li[2]+Li[0],ie+=Li[0]}function yt(){let _=J+v,M=ie+k,C=J,L=ie;function H(Y,se){switch(Y){case 1:return _+=se,_-se;case 2:return M+=se,M-se;case 3:return C-=se,C+se;case 0:return L-=se,L+se}}w.forEach((Y,se)=>{if(Y.show&&Y._show){let ce=Y.side;Y._pos=H(ce,Y._size),Y.label!=null&&(Y._lpos=H(ce,Y.labelSize))}})}if(_e.dataIdx==null){let _=_e.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let C=_.prox=pt(_.prox),L=_.bias??=0;_e.dataIdx=(H,Y,se,ce)=>{if(Y==0)return se;let me=se,Ae=C(H,Y,se,ce)??kt,Ce=Ae>=0&&Ae<kt,Ne=R.ori==0?v:k,it=_e.left,Mt=e[0],vt=e[Y];if(M.has(vt[se])){me=null;let ht=null,Je=null,Ge;if(L==0||L==-1)for(Ge=se;ht==null&&Ge-- >0;)M.has(vt[Ge])||(ht=Ge);if(L==0||L==1)for(Ge=se;Je==null&&Ge++<vt.length;)M.has(vt[Ge])||(Je=Ge);if(ht!=null||Je!=null)if(Ce){let $t=ht==null?-1/0:V(Mt[ht],R,Ne,0),jt=Je==null?1/0:V(Mt[Je],R,Ne,0),_n=it-$t,It=jt-it;_n<=It?_n<=Ae&&(me=ht):It<=Ae&&(me=Je)}else me=Je==null?ht:ht==null?Je:se-ht<=Je-se?ht:Je}else Ce&&un(it-V(Mt[se],R,Ne,0))>Ae&&(me=null);return me}}let vn=_=>{_e.event=_};_e.idxs=ye,_e._lock=!1;let Dt=_e.points;Dt.show=pt(Dt.show),Dt.size=pt(Dt.size),Dt.stroke=pt(Dt.stroke),Dt.width=pt(Dt.width),Dt.fill=pt(Dt.fill);let Hn=n.focus=sn({},i.focus||{alpha:.3},_e.focus),On=Hn.prox>=0,Ii=On&&Dt.one,Cn=[],Yi=[],mi=[];function No(_,M){let C=Dt.show(n,M);if(C instanceof HTMLElement)return Qn(C,m1),Qn(C,_.class),qi(C,-10,-10,v,k),g.insertBefore(C,Cn[M]),C}function Hs(_,M){if(s==1||M>0){let C=s==1&&x[_.scale].time,L=_.value;_.value=C?H_(L)?Y_(q,q_(L,Q)):L||le:L||CA,_.label=_.label||(C?bA:vA)}if(Ii||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||GA||D1,_.fillTo=pt(_.fillTo||NA),_.pxAlign=+bt(_.pxAlign,y),_.pxRound=iy(_.pxAlign),_.stroke=pt(_.stroke||null),_.fill=pt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let C=PA(Un(1,_.width),1),L=_.points=sn({},{size:C,width:Un(1,C*.2),stroke:_.stroke,space:C*2,paths:WA,_stroke:null,_fill:null},_.points);L.show=pt(L.show),L.filter=pt(L.filter),L.fill=pt(L.fill),L.stroke=pt(L.stroke),L.paths=pt(L.paths),L.pxAlign=_.pxAlign}if(st){let C=At(_,M);xe.splice(M,0,C[0]),tt.splice(M,0,C[1]),we.values.push(null)}if(et){ye.splice(M,0,null);let C=null;Ii?M==0&&(C=No(_,M)):M>0&&(C=No(_,M)),Cn.splice(M,0,C),Yi.splice(M,0,0),mi.splice(M,0,0)}gn("addSeries",M)}function tl(_,M){M=M??b.length,_=s==1?Yf(_,M,K_,ty):Yf(_,M,{},ey),b.splice(M,0,_),Hs(b[M],M)}n.addSeries=tl;function nl(_){if(b.splice(_,1),st){we.values.splice(_,1),tt.splice(_,1);let M=xe.splice(_,1)[0];Gt(null,M.firstChild),M.remove()}et&&(ye.splice(_,1),Cn.splice(_,1)[0].remove(),Yi.splice(_,1),mi.splice(_,1)),gn("delSeries",_)}n.delSeries=nl;let Zi=[!1,!1,!1,!1];function _u(_,M){if(_._show=_.show,_.show){let C=_.side%2,L=x[_.scale];L==null&&(_.scale=C?b[1].scale:A,L=x[_.scale]);let H=L.time;_.size=pt(_.size),_.space=pt(_.space),_.rotate=pt(_.rotate),Os(_.incrs)&&_.incrs.forEach(se=>{!Bs.has(se)&&Bs.set(se,gy(se))}),_.incrs=pt(_.incrs||(L.distr==2?tA:H?p==1?iA:oA:Er)),_.splits=pt(_.splits||(H&&L.distr==1?Z:L.distr==3?Wf:L.distr==4?SA:MA)),_.stroke=pt(_.stroke),_.grid.stroke=pt(_.grid.stroke),_.ticks.stroke=pt(_.ticks.stroke),_.border.stroke=pt(_.border.stroke);let Y=_.values;_.values=Os(Y)&&!Os(Y[0])?pt(Y):H?Os(Y)?$_(q,X_(Y,Q)):H_(Y)?cA(q,Y):Y||ae:Y||wA,_.filter=pt(_.filter||(L.distr>=3&&L.log==10?AA:L.distr==3&&L.log==2?RA:py)),_.font=ay(_.font),_.labelFont=ay(_.labelFont),_._size=_.size(n,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Zi[M]=!0,_._el=di(u1,d))}}function Vs(_,M,C,L){let[H,Y,se,ce]=C,me=M%2,Ae=0;return me==0&&(ce||Y)&&(Ae=M==0&&!H||M==2&&!se?hn(Z_.size/3):0),me==1&&(H||se)&&(Ae=M==1&&!Y||M==3&&!ce?hn(j_.size/2):0),Ae}let il=n.padding=(i.padding||[Vs,Vs,Vs,Vs]).map(_=>pt(bt(_,Vs))),Li=n._padding=il.map((_,M)=>_(n,M,Zi,0)),rn,E=null,G=null,j=s==1?b[0].idxs:null,K=null,W=!1;function fe(_,M){if(e=_??[],n.data=n._data=e,s==2){rn=0;for(let C=1;C<b.length;C++)rn+=e[C][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),K=e[0],rn=K.length;let C=e;if(B==2){C=e.slice();let L=C[0]=Array(rn);for(let H=0;H<rn;H++)L[H]=H}n._data=e=C}if(Ir(!0),gn("setData"),B==2&&(je=!0),M!==!1){let C=R;C.auto(n,W)?Me():gs(A,C.min,C.max),z=z||_e.left>=0,pe=!0,Lr()}}n.setData=fe;function Me(){W=!0;let _,M;s==1&&(rn>0?(E=j[0]=0,G=j[1]=rn-1,_=e[0][E],M=e[0][G],B==2?(_=E,M=G):_==M&&(B==3?[_,M]=ru(_,_,R.log,!1):B==4?[_,M]=jf(_,_,R.log,!1):R.time?M=_+hn(86400/p):[_,M]=nu(_,M,Qf,!0))):(E=j[0]=_=null,G=j[1]=M=null)),gs(A,_,M)}let De,Te,qe,Ye,Ve,at,xt,Ot,Rt,rt;function $e(_,M,C,L,H,Y){_??=S_,C??=tp,L??="butt",H??=S_,Y??="round",_!=De&&(u.strokeStyle=De=_),H!=Te&&(u.fillStyle=Te=H),M!=qe&&(u.lineWidth=qe=M),Y!=Ve&&(u.lineJoin=Ve=Y),L!=at&&(u.lineCap=at=L),C!=Ye&&u.setLineDash(Ye=C)}function Bt(_,M,C,L){M!=Te&&(u.fillStyle=Te=M),_!=xt&&(u.font=xt=_),C!=Ot&&(u.textAlign=Ot=C),L!=Rt&&(u.textBaseline=Rt=L)}function dt(_,M,C,L,H=0){if(L.length>0&&_.auto(n,W)&&(M==null||M.min==null)){let Y=bt(E,0),se=bt(G,L.length-1),ce=C.min==null?A1(L,Y,se,H,_.distr==3):[C.min,C.max];_.min=Pi(_.min,C.min=ce[0]),_.max=Un(_.max,C.max=ce[1])}}let Sn={min:null,max:null};function fs(){for(let L in x){let H=x[L];$[L]==null&&(H.min==null||$[A]!=null&&H.auto(n,W))&&($[L]=Sn)}for(let L in x){let H=x[L];$[L]==null&&H.from!=null&&$[H.from]!=null&&($[L]=Sn)}$[A]!=null&&Ir(!0);let _={};for(let L in $){let H=$[L];if(H!=null){let Y=_[L]=Co(x[L],F1);if(H.min!=null)sn(Y,H);else if(L!=A||s==2)if(rn==0&&Y.from==null){let se=Y.range(n,null,null,L);Y.min=se[0],Y.max=se[1]}else Y.min=kt,Y.max=-kt}}if(rn>0){b.forEach((L,H)=>{if(s==1){let Y=L.scale,se=$[Y];if(se==null)return;let ce=_[Y];if(H==0){let me=ce.range(n,ce.min,ce.max,Y);ce.min=me[0],ce.max=me[1],E=Ci(ce.min,e[0]),G=Ci(ce.max,e[0]),G-E>1&&(e[0][E]<ce.min&&E++,e[0][G]>ce.max&&G--),L.min=K[E],L.max=K[G]}else L.show&&L.auto&&dt(ce,se,L,e[H],L.sorted);L.idxs[0]=E,L.idxs[1]=G}else if(H>0&&L.show&&L.auto){let[Y,se]=L.facets,ce=Y.scale,me=se.scale,[Ae,Ce]=e[H],Ne=_[ce],it=_[me];Ne!=null&&dt(Ne,$[ce],Y,Ae,Y.sorted),it!=null&&dt(it,$[me],se,Ce,se.sorted),L.min=se.min,L.max=se.max}});for(let L in _){let H=_[L],Y=$[L];if(H.from==null&&(Y==null||Y.min==null)){let se=H.range(n,H.min==kt?null:H.min,H.max==-kt?null:H.max,L);H.min=se[0],H.max=se[1]}}}for(let L in _){let H=_[L];if(H.from!=null){let Y=_[H.from];if(Y.min==null)H.min=H.max=null;else{let se=H.range(n,Y.min,Y.max,L);H.min=se[0],H.max=se[1]}}}let M={},C=!1;for(let L in _){let H=_[L],Y=x[L];if(Y.min!=H.min||Y.max!=H.max){Y.min=H.min,Y.max=H.max;let se=Y.distr;Y._min=se==3?us(Y.min):se==4?kf(Y.min,Y.asinh):se==100?Y.fwd(Y.min):Y.min,Y._max=se==3?us(Y.max):se==4?kf(Y.max,Y.asinh):se==100?Y.fwd(Y.max):Y.max,M[L]=C=!0}}if(C){b.forEach((L,H)=>{s==2?H>0&&M.y&&(L._paths=null):M[L.scale]&&(L._paths=null)});for(let L in M)je=!0,gn("setScale",L);et&&_e.left>=0&&(z=pe=!0)}for(let L in $)$[L]=null}function Pn(_){let M=Gf(E-1,0,rn-1),C=Gf(G+1,0,rn-1);for(;_[M]==null&&M>0;)M--;for(;_[C]==null&&C<rn-1;)C++;return[M,C]}function Gs(){if(rn>0){let _=b.some(M=>M._focus)&&rt!=Hn.alpha;_&&(u.globalAlpha=rt=Hn.alpha),b.forEach((M,C)=>{if(C>0&&M.show&&(zt(C,!1),zt(C,!0),M._paths==null)){let L=rt;rt!=M.alpha&&(u.globalAlpha=rt=M.alpha);let H=s==2?[0,e[C][0].length-1]:Pn(e[C]);M._paths=M.paths(n,C,H[0],H[1]),rt!=L&&(u.globalAlpha=rt=L)}}),b.forEach((M,C)=>{if(C>0&&M.show){let L=rt;rt!=M.alpha&&(u.globalAlpha=rt=M.alpha),M._paths!=null&&In(C,!1);{let H=M._paths!=null?M._paths.gaps:null,Y=M.points.show(n,C,E,G,H),se=M.points.filter(n,C,Y,H);(Y||se)&&(M.points._paths=M.points.paths(n,C,E,G,se),In(C,!0))}rt!=L&&(u.globalAlpha=rt=L),gn("drawSeries",C)}}),_&&(u.globalAlpha=rt=1)}}function zt(_,M){let C=M?b[_].points:b[_];C._stroke=C.stroke(n,_),C._fill=C.fill(n,_)}function In(_,M){let C=M?b[_].points:b[_],{stroke:L,fill:H,clip:Y,flags:se,_stroke:ce=C._stroke,_fill:me=C._fill,_width:Ae=C.width}=C._paths;Ae=Ft(Ae*St,3);let Ce=null,Ne=Ae%2/2;M&&me==null&&(me=Ae>0?"#fff":ce);let it=C.pxAlign==1&&Ne>0;if(it&&u.translate(Ne,Ne),!M){let Mt=Re-Ae/2,vt=oe-Ae/2,ht=ge+Ae,Je=ze+Ae;Ce=new Path2D,Ce.rect(Mt,vt,ht,Je)}M?fn(ce,Ae,C.dash,C.cap,me,L,H,se,Y):Bn(_,ce,Ae,C.dash,C.cap,me,L,H,se,Ce,Y),it&&u.translate(-Ne,-Ne)}function Bn(_,M,C,L,H,Y,se,ce,me,Ae,Ce){let Ne=!1;me!=0&&P.forEach((it,Mt)=>{if(it.series[0]==_){let vt=b[it.series[1]],ht=e[it.series[1]],Je=(vt._paths||Ja).band;Os(Je)&&(Je=it.dir==1?Je[0]:Je[1]);let Ge,$t=null;vt.show&&Je&&C1(ht,E,G)?($t=it.fill(n,Mt)||Y,Ge=vt._paths.clip):Je=null,fn(M,C,L,H,$t,se,ce,me,Ae,Ce,Ge,Je),Ne=!0}}),Ne||fn(M,C,L,H,Y,se,ce,me,Ae,Ce)}let dn=Po|$f;function fn(_,M,C,L,H,Y,se,ce,me,Ae,Ce,Ne){$e(_,M,C,L,H),(me||Ae||Ne)&&(u.save(),me&&u.clip(me),Ae&&u.clip(Ae)),Ne?(ce&dn)==dn?(u.clip(Ne),Ce&&u.clip(Ce),ii(H,se),ps(_,Y,M)):ce&$f?(ii(H,se),u.clip(Ne),ps(_,Y,M)):ce&Po&&(u.save(),u.clip(Ne),Ce&&u.clip(Ce),ii(H,se),u.restore(),ps(_,Y,M)):(ii(H,se),ps(_,Y,M)),(me||Ae||Ne)&&u.restore()}function ps(_,M,C){C>0&&(M instanceof Map?M.forEach((L,H)=>{u.strokeStyle=De=H,u.stroke(L)}):M!=null&&_&&u.stroke(M))}function ii(_,M){M instanceof Map?M.forEach((C,L)=>{u.fillStyle=Te=L,u.fill(C)}):M!=null&&_&&u.fill(M)}function gx(_,M,C,L){let H=w[_],Y;if(L<=0)Y=[0,0];else{let se=H._space=H.space(n,_,M,C,L),ce=H._incrs=H.incrs(n,_,M,C,L,se);Y=KA(M,C,ce,L,se)}return H._found=Y}function yu(_,M,C,L,H,Y,se,ce,me,Ae){let Ce=se%2/2;y==1&&u.translate(Ce,Ce),$e(ce,se,me,Ae,ce),u.beginPath();let Ne,it,Mt,vt,ht=H+(L==0||L==3?-Y:Y);C==0?(it=H,vt=ht):(Ne=H,Mt=ht);for(let Je=0;Je<_.length;Je++)M[Je]!=null&&(C==0?Ne=Mt=_[Je]:it=vt=_[Je],u.moveTo(Ne,it),u.lineTo(Mt,vt));u.stroke(),y==1&&u.translate(-Ce,-Ce)}function _x(_){let M=!0;return w.forEach((C,L)=>{if(!C.show)return;let H=x[C.scale];if(H.min==null){C._show&&(M=!1,C._show=!1,Ir(!1));return}else C._show||(M=!1,C._show=!0,Ir(!1));let Y=C.side,se=Y%2,{min:ce,max:me}=H,[Ae,Ce]=gx(L,ce,me,se==0?v:k);if(Ce==0)return;let Ne=H.distr==2,it=C._splits=C.splits(n,L,ce,me,Ae,Ce,Ne),Mt=H.distr==2?it.map(Ge=>K[Ge]):it,vt=H.distr==2?K[it[1]]-K[it[0]]:Ae,ht=C._values=C.values(n,C.filter(n,Mt,L,Ce,vt),L,Ce,vt);C._rotate=Y==2?C.rotate(n,ht,L,Ce):0;let Je=C._size;C._size=fi(C.size(n,ht,L,_)),Je!=null&&C._size!=Je&&(M=!1)}),M}function yx(_){let M=!0;return il.forEach((C,L)=>{let H=C(n,L,Zi,_);H!=Li[L]&&(M=!1),Li[L]=H}),M}function xx(){for(let _=0;_<w.length;_++){let M=w[_];if(!M.show||!M._show)continue;let C=M.side,L=C%2,H,Y,se=M.stroke(n,_),ce=C==0||C==3?-1:1,[me,Ae]=M._found;if(M.label!=null){let Dn=M.labelGap*ce,Wn=hn((M._lpos+Dn)*St);Bt(M.labelFont[0],se,"center",C==2?"top":M_),u.save(),L==1?(H=Y=0,u.translate(Wn,hn(oe+ze/2)),u.rotate((C==3?-eu:eu)/2)):(H=hn(Re+ge/2),Y=Wn);let $s=dy(M.label)?M.label(n,_,me,Ae):M.label;u.fillText($s,H,Y),u.restore()}if(Ae==0)continue;let Ce=x[M.scale],Ne=L==0?ge:ze,it=L==0?Re:oe,Mt=M._splits,vt=Ce.distr==2?Mt.map(Dn=>K[Dn]):Mt,ht=Ce.distr==2?K[Mt[1]]-K[Mt[0]]:me,Je=M.ticks,Ge=M.border,$t=Je.show?Je.size:0,jt=hn($t*St),_n=hn((M.alignTo==2?M._size-$t-M.gap:M.gap)*St),It=M._rotate*-eu/180,Qt=m(M._pos*St),Vn=(jt+_n)*ce,Ln=Qt+Vn;Y=L==0?Ln:0,H=L==1?Ln:0;let si=M.font[0],gi=M.align==1?So:M.align==2?Lf:It>0?So:It<0?Lf:L==0?"center":C==3?Lf:So,ki=It||L==1?"middle":C==2?"top":M_;Bt(si,se,gi,ki);let Gn=M.font[1]*M.lineGap,ri=Mt.map(Dn=>m(a(Dn,Ce,Ne,it))),_i=M._values;for(let Dn=0;Dn<_i.length;Dn++){let Wn=_i[Dn];if(Wn!=null){L==0?H=ri[Dn]:Y=ri[Dn],Wn=""+Wn;let $s=Wn.indexOf(`
`)==-1?[Wn]:Wn.split(/\n/gm);for(let Nn=0;Nn<$s.length;Nn++){let Dp=$s[Nn];It?(u.save(),u.translate(H,Y+Nn*Gn),u.rotate(It),u.fillText(Dp,0,0),u.restore()):u.fillText(Dp,H,Y+Nn*Gn)}}}Je.show&&yu(ri,Je.filter(n,vt,_,Ae,ht),L,C,Qt,jt,Ft(Je.width*St,3),Je.stroke(n,_),Je.dash,Je.cap);let Fi=M.grid;Fi.show&&yu(ri,Fi.filter(n,vt,_,Ae,ht),L,L==0?2:1,L==0?oe:Re,L==0?ze:ge,Ft(Fi.width*St,3),Fi.stroke(n,_),Fi.dash,Fi.cap),Ge.show&&yu([Qt],[1],L==0?1:0,L==0?1:2,L==1?oe:Re,L==1?ze:ge,Ft(Ge.width*St,3),Ge.stroke(n,_),Ge.dash,Ge.cap)}gn("drawAxes")}function Ir(_){b.forEach((M,C)=>{C>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(L=>{L.min=null,L.max=null})))})}let sl=!1,xu=!1,ko=[];function vx(){xu=!1;for(let _=0;_<ko.length;_++)gn(...ko[_]);ko.length=0}function Lr(){sl||(G1(mp),sl=!0)}function bx(_,M=!1){sl=!0,xu=M,_(n),mp(),M&&ko.length>0&&queueMicrotask(vx)}n.batch=bx;function mp(){if(Oe&&(fs(),Oe=!1),je&&(Ue(),je=!1),ve){if(Yt(f,So,J),Yt(f,"top",ie),Yt(f,qa,v),Yt(f,Ya,k),Yt(g,So,J),Yt(g,"top",ie),Yt(g,qa,v),Yt(g,Ya,k),Yt(d,qa,wt),Yt(d,Ya,I),h.width=hn(wt*St),h.height=hn(I*St),w.forEach(({_el:_,_show:M,_size:C,_pos:L,side:H})=>{if(_!=null)if(M){let Y=H===3||H===0?C:0,se=H%2==1;Yt(_,se?"left":"top",L-Y),Yt(_,se?"width":"height",C),Yt(_,se?"top":"left",se?ie:J),Yt(_,se?"height":"width",se?k:v),Hf(_,Tr)}else Qn(_,Tr)}),De=Te=qe=Ve=at=xt=Ot=Rt=Ye=null,rt=1,Oo(!0),J!=te||ie!=Fe||v!=ue||k!=Le){Ir(!1);let _=v/ue,M=k/Le;if(et&&!z&&_e.left>=0){_e.left*=_,_e.top*=M,Dr&&qi(Dr,hn(_e.left),0,v,k),Nr&&qi(Nr,0,hn(_e.top),v,k);for(let C=0;C<Cn.length;C++){let L=Cn[C];L!=null&&(Yi[C]*=_,mi[C]*=M,qi(L,fi(Yi[C]),fi(mi[C]),v,k))}}if(Xt.show&&!de&&Xt.left>=0&&Xt.width>0){Xt.left*=_,Xt.width*=_,Xt.top*=M,Xt.height*=M;for(let C in Eu)Yt(Ur,C,Xt[C])}te=J,Fe=ie,ue=v,Le=k}gn("setSize"),ve=!1}wt>0&&I>0&&(u.clearRect(0,0,h.width,h.height),gn("drawClear"),F.forEach(_=>_()),gn("draw")),Xt.show&&de&&(rl(Xt),de=!1),et&&z&&(Xs(null,!0,!1),z=!1),we.show&&we.live&&pe&&(Mu(),pe=!1),l||(l=!0,n.status=1,gn("ready")),W=!1,sl=!1}n.redraw=(_,M)=>{je=M||!1,_!==!1?gs(A,R.min,R.max):Lr()};function vu(_,M){let C=x[_];if(C.from==null){if(rn==0){let L=C.range(n,M.min,M.max,_);M.min=L[0],M.max=L[1]}if(M.min>M.max){let L=M.min;M.min=M.max,M.max=L}if(rn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&C.distr==2&&rn>0&&(M.min=Ci(M.min,e[0]),M.max=Ci(M.max,e[0]),M.min==M.max&&M.max++),$[_]=M,Oe=!0,Lr()}}n.setScale=vu;let bu,wu,Dr,Nr,gp,_p,kr,Fr,yp,xp,Wt,Zt,ms=!1,bn=_e.drag,pn=bn.x,mn=bn.y;et&&(_e.x&&(bu=di(f1,g)),_e.y&&(wu=di(p1,g)),R.ori==0?(Dr=bu,Nr=wu):(Dr=wu,Nr=bu),Wt=_e.left,Zt=_e.top);let Xt=n.select=sn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Ur=Xt.show?di(d1,Xt.over?g:f):null;function rl(_,M){if(Xt.show){for(let C in _)Xt[C]=_[C],C in Eu&&Yt(Ur,C,_[C]);M!==!1&&gn("setSelect")}}n.setSelect=rl;function wx(_){if(b[_].show)st&&Hf(xe[_],Tr);else if(st&&Qn(xe[_],Tr),et){let C=Ii?Cn[0]:Cn[_];C!=null&&qi(C,-10,-10,v,k)}}function gs(_,M,C){vu(_,{min:M,max:C})}function Di(_,M,C,L){M.focus!=null&&Ax(_),M.show!=null&&b.forEach((H,Y)=>{Y>0&&(_==Y||_==null)&&(H.show=M.show,wx(Y),s==2?(gs(H.facets[0].scale,null,null),gs(H.facets[1].scale,null,null)):gs(H.scale,null,null),Lr())}),C!==!1&&gn("setSeries",_,M),L&&Bo("setSeries",n,_,M)}n.setSeries=Di;function Mx(_,M){sn(P[_],M)}function Sx(_,M){_.fill=pt(_.fill||null),_.dir=bt(_.dir,-1),M=M??P.length,P.splice(M,0,_)}function Ex(_){_==null?P.length=0:P.splice(_,1)}n.addBand=Sx,n.setBand=Mx,n.delBand=Ex;function Tx(_,M){b[_].alpha=M,et&&Cn[_]!=null&&(Cn[_].style.opacity=M),st&&xe[_]&&(xe[_].style.opacity=M)}let Ki,_s,Ws,Or={focus:!0};function Ax(_){if(_!=Ws){let M=_==null,C=Hn.alpha!=1;b.forEach((L,H)=>{if(s==1||H>0){let Y=M||H==0||H==_;L._focus=M?null:Y,C&&Tx(H,Y?1:Hn.alpha)}}),Ws=_,C&&Lr()}}st&&On&&We(A_,ne,_=>{_e._lock||(vn(_),Ws!=null&&Di(null,Or,!0,tn.setSeries))});function Ni(_,M,C){let L=x[M];C&&(_=_/St-(L.ori==1?ie:J));let H=v;L.ori==1&&(H=k,_=H-_),L.dir==-1&&(_=H-_);let Y=L._min,se=L._max,ce=_/H,me=Y+(se-Y)*ce,Ae=L.distr;return Ae==3?Ao(10,me):Ae==4?I1(me,L.asinh):Ae==100?L.bwd(me):me}function Rx(_,M){let C=Ni(_,A,M);return Ci(C,e[0],E,G)}n.valToIdx=_=>Ci(_,e[0]),n.posToIdx=Rx,n.posToVal=Ni,n.valToPos=(_,M,C)=>x[M].ori==0?r(_,x[M],C?ge:v,C?Re:0):o(_,x[M],C?ze:k,C?oe:0),n.setCursor=(_,M,C)=>{Wt=_.left,Zt=_.top,Xs(null,M,C)};function vp(_,M){Yt(Ur,So,Xt.left=_),Yt(Ur,qa,Xt.width=M)}function bp(_,M){Yt(Ur,"top",Xt.top=_),Yt(Ur,Ya,Xt.height=M)}let Fo=R.ori==0?vp:bp,Uo=R.ori==1?vp:bp;function Cx(){if(st&&we.live)for(let _=s==2?1:0;_<b.length;_++){if(_==0&&N)continue;let M=we.values[_],C=0;for(let L in M)tt[_][C++].firstChild.nodeValue=M[L]}}function Mu(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((C,L)=>{ye[L]=C}):k1(_.idx)||ye.fill(_.idx),we.idx=ye[0]),st&&we.live){for(let C=0;C<b.length;C++)(C>0||s==1&&!N)&&Px(C,ye[C]);Cx()}pe=!1,M!==!1&&gn("setLegend")}n.setLegend=Mu;function Px(_,M){let C=b[_],L=_==0&&B==2?K:e[_],H;N?H=C.values(n,_,M)??gt:(H=C.value(n,M==null?null:L[M],_,M),H=H==null?gt:{_:H}),we.values[_]=H}function Xs(_,M,C){yp=Wt,xp=Zt,[Wt,Zt]=_e.move(n,Wt,Zt),_e.left=Wt,_e.top=Zt,et&&(Dr&&qi(Dr,hn(Wt),0,v,k),Nr&&qi(Nr,0,hn(Zt),v,k));let L,H=E>G;Ki=kt,_s=null;let Y=R.ori==0?v:k,se=R.ori==1?v:k;if(Wt<0||rn==0||H){L=_e.idx=null;for(let ce=0;ce<b.length;ce++){let me=Cn[ce];me!=null&&qi(me,-10,-10,v,k)}On&&Di(null,Or,!0,_==null&&tn.setSeries),we.live&&(ye.fill(L),pe=!0)}else{let ce,me,Ae;s==1&&(ce=R.ori==0?Wt:Zt,me=Ni(ce,A),L=_e.idx=Ci(me,e[0],E,G),Ae=V(e[0][L],R,Y,0));let Ce=-10,Ne=-10,it=0,Mt=0,vt=!0,ht="",Je="";for(let Ge=s==2?1:0;Ge<b.length;Ge++){let $t=b[Ge],jt=ye[Ge],_n=jt==null?null:s==1?e[Ge][jt]:e[Ge][1][jt],It=_e.dataIdx(n,Ge,L,me),Qt=It==null?null:s==1?e[Ge][It]:e[Ge][1][It];if(pe=pe||Qt!=_n||It!=jt,ye[Ge]=It,Ge>0&&$t.show){let Vn=It==null?-10:It==L?Ae:V(s==1?e[0][It]:e[Ge][0][It],R,Y,0),Ln=Qt==null?-10:X(Qt,s==1?x[$t.scale]:x[$t.facets[1].scale],se,0);if(On&&Qt!=null){let si=R.ori==1?Wt:Zt,gi=un(Hn.dist(n,Ge,It,Ln,si));if(gi<Ki){let ki=Hn.bias;if(ki!=0){let Gn=Ni(si,$t.scale),ri=Qt>=0?1:-1,_i=Gn>=0?1:-1;_i==ri&&(_i==1?ki==1?Qt>=Gn:Qt<=Gn:ki==1?Qt<=Gn:Qt>=Gn)&&(Ki=gi,_s=Ge)}else Ki=gi,_s=Ge}}if(pe||Ii){let si,gi;R.ori==0?(si=Vn,gi=Ln):(si=Ln,gi=Vn);let ki,Gn,ri,_i,Fi,Dn,Wn=!0,$s=Dt.bbox;if($s!=null){Wn=!1;let Nn=$s(n,Ge);ri=Nn.left,_i=Nn.top,ki=Nn.width,Gn=Nn.height}else ri=si,_i=gi,ki=Gn=Dt.size(n,Ge);if(Dn=Dt.fill(n,Ge),Fi=Dt.stroke(n,Ge),Ii)Ge==_s&&Ki<=Hn.prox&&(Ce=ri,Ne=_i,it=ki,Mt=Gn,vt=Wn,ht=Dn,Je=Fi);else{let Nn=Cn[Ge];Nn!=null&&(Yi[Ge]=ri,mi[Ge]=_i,N_(Nn,ki,Gn,Wn),L_(Nn,Dn,Fi),qi(Nn,fi(ri),fi(_i),v,k))}}}}if(Ii){let Ge=Hn.prox,$t=Ws==null?Ki<=Ge:Ki>Ge||_s!=Ws;if(pe||$t){let jt=Cn[0];jt!=null&&(Yi[0]=Ce,mi[0]=Ne,N_(jt,it,Mt,vt),L_(jt,ht,Je),qi(jt,fi(Ce),fi(Ne),v,k))}}}if(Xt.show&&ms)if(_!=null){let[ce,me]=tn.scales,[Ae,Ce]=tn.match,[Ne,it]=_.cursor.sync.scales,Mt=_.cursor.drag;if(pn=Mt._x,mn=Mt._y,pn||mn){let{left:vt,top:ht,width:Je,height:Ge}=_.select,$t=_.scales[Ne].ori,jt=_.posToVal,_n,It,Qt,Vn,Ln,si=ce!=null&&Ae(ce,Ne),gi=me!=null&&Ce(me,it);si&&pn?($t==0?(_n=vt,It=Je):(_n=ht,It=Ge),Qt=x[ce],Vn=V(jt(_n,Ne),Qt,Y,0),Ln=V(jt(_n+It,Ne),Qt,Y,0),Fo(Pi(Vn,Ln),un(Ln-Vn))):Fo(0,Y),gi&&mn?($t==1?(_n=vt,It=Je):(_n=ht,It=Ge),Qt=x[me],Vn=X(jt(_n,it),Qt,se,0),Ln=X(jt(_n+It,it),Qt,se,0),Uo(Pi(Vn,Ln),un(Ln-Vn))):Uo(0,se)}else Tu()}else{let ce=un(yp-gp),me=un(xp-_p);if(R.ori==1){let it=ce;ce=me,me=it}pn=bn.x&&ce>=bn.dist,mn=bn.y&&me>=bn.dist;let Ae=bn.uni;Ae!=null?pn&&mn&&(pn=ce>=Ae,mn=me>=Ae,!pn&&!mn&&(me>ce?mn=!0:pn=!0)):bn.x&&bn.y&&(pn||mn)&&(pn=mn=!0);let Ce,Ne;pn&&(R.ori==0?(Ce=kr,Ne=Wt):(Ce=Fr,Ne=Zt),Fo(Pi(Ce,Ne),un(Ne-Ce)),mn||Uo(0,se)),mn&&(R.ori==1?(Ce=kr,Ne=Wt):(Ce=Fr,Ne=Zt),Uo(Pi(Ce,Ne),un(Ne-Ce)),pn||Fo(0,Y)),!pn&&!mn&&(Fo(0,0),Uo(0,0))}if(bn._x=pn,bn._y=mn,_==null){if(C){if(Lp!=null){let[ce,me]=tn.scales;tn.values[0]=ce!=null?Ni(R.ori==0?Wt:Zt,ce):null,tn.values[1]=me!=null?Ni(R.ori==1?Wt:Zt,me):null}Bo(Df,n,Wt,Zt,v,k,L)}if(On){let ce=C&&tn.setSeries,me=Hn.prox;Ws==null?Ki<=me&&Di(_s,Or,!0,ce):Ki>me?Di(null,Or,!0,ce):_s!=Ws&&Di(_s,Or,!0,ce)}}pe&&(we.idx=L,Mu()),M!==!1&&gn("setCursor")}let ys=null;Object.defineProperty(n,"rect",{get(){return ys==null&&Oo(!1),ys}});function Oo(_=!1){_?ys=null:(ys=g.getBoundingClientRect(),gn("syncRect",ys))}function wp(_,M,C,L,H,Y,se){_e._lock||ms&&_!=null&&_.movementX==0&&_.movementY==0||(Su(_,M,C,L,H,Y,se,!1,_!=null),_!=null?Xs(null,!0,!0):Xs(M,!0,!1))}function Su(_,M,C,L,H,Y,se,ce,me){if(ys==null&&Oo(!1),vn(_),_!=null)C=_.clientX-ys.left,L=_.clientY-ys.top;else{if(C<0||L<0){Wt=-10,Zt=-10;return}let[Ae,Ce]=tn.scales,Ne=M.cursor.sync,[it,Mt]=Ne.values,[vt,ht]=Ne.scales,[Je,Ge]=tn.match,$t=M.axes[0].side%2==1,jt=R.ori==0?v:k,_n=R.ori==1?v:k,It=$t?Y:H,Qt=$t?H:Y,Vn=$t?L:C,Ln=$t?C:L;if(vt!=null?C=Je(Ae,vt)?a(it,x[Ae],jt,0):-10:C=jt*(Vn/It),ht!=null?L=Ge(Ce,ht)?a(Mt,x[Ce],_n,0):-10:L=_n*(Ln/Qt),R.ori==1){let si=C;C=L,L=si}}me&&(M==null||M.cursor.event.type==Df)&&((C<=1||C>=v-1)&&(C=Sr(C,v)),(L<=1||L>=k-1)&&(L=Sr(L,k))),ce?(gp=C,_p=L,[kr,Fr]=_e.move(n,C,L)):(Wt=C,Zt=L)}let Eu={width:0,height:0,left:0,top:0};function Tu(){rl(Eu,!1)}let Mp,Sp,Ep,Tp;function Ap(_,M,C,L,H,Y,se){ms=!0,pn=mn=bn._x=bn._y=!1,Su(_,M,C,L,H,Y,se,!0,!1),_!=null&&(We(Nf,Bf,Rp,!1),Bo(E_,n,kr,Fr,v,k,null));let{left:ce,top:me,width:Ae,height:Ce}=Xt;Mp=ce,Sp=me,Ep=Ae,Tp=Ce}function Rp(_,M,C,L,H,Y,se){ms=bn._x=bn._y=!1,Su(_,M,C,L,H,Y,se,!1,!0);let{left:ce,top:me,width:Ae,height:Ce}=Xt,Ne=Ae>0||Ce>0,it=Mp!=ce||Sp!=me||Ep!=Ae||Tp!=Ce;if(Ne&&it&&rl(Xt),bn.setScale&&Ne&&it){let Mt=ce,vt=Ae,ht=me,Je=Ce;if(R.ori==1&&(Mt=me,vt=Ce,ht=ce,Je=Ae),pn&&gs(A,Ni(Mt,A),Ni(Mt+vt,A)),mn)for(let Ge in x){let $t=x[Ge];Ge!=A&&$t.from==null&&$t.min!=kt&&gs(Ge,Ni(ht+Je,Ge),Ni(ht,Ge))}Tu()}else _e.lock&&(_e._lock=!_e._lock,Xs(M,!0,_!=null));_!=null&&(Gt(Nf,Bf),Bo(Nf,n,Wt,Zt,v,k,null))}function Ix(_,M,C,L,H,Y,se){if(_e._lock)return;vn(_);let ce=ms;if(ms){let me=!0,Ae=!0,Ce=10,Ne,it;R.ori==0?(Ne=pn,it=mn):(Ne=mn,it=pn),Ne&&it&&(me=Wt<=Ce||Wt>=v-Ce,Ae=Zt<=Ce||Zt>=k-Ce),Ne&&me&&(Wt=Wt<kr?0:v),it&&Ae&&(Zt=Zt<Fr?0:k),Xs(null,!0,!0),ms=!1}Wt=-10,Zt=-10,ye.fill(null),Xs(null,!0,!0),ce&&(ms=ce)}function Cp(_,M,C,L,H,Y,se){_e._lock||(vn(_),Me(),Tu(),_!=null&&Bo(R_,n,Wt,Zt,v,k,null))}function Pp(){w.forEach(JA),Ie(n.width,n.height,!0)}Ar(tu,To,Pp);let Br={};Br.mousedown=Ap,Br.mousemove=wp,Br.mouseup=Rp,Br.dblclick=Cp,Br.setSeries=(_,M,C,L)=>{let H=tn.match[2];C=H(n,M,C),C!=-1&&Di(C,L,!0,!1)},et&&(We(E_,g,Ap),We(Df,g,wp),We(T_,g,_=>{vn(_),Oo(!1)}),We(A_,g,Ix),We(R_,g,Cp),qf.add(n),n.syncRect=Oo);let ol=n.hooks=i.hooks||{};function gn(_,M,C){xu?ko.push([_,M,C]):_ in ol&&ol[_].forEach(L=>{L.call(null,n,M,C)})}(i.plugins||[]).forEach(_=>{for(let M in _.hooks)ol[M]=(ol[M]||[]).concat(_.hooks[M])});let Ip=(_,M,C)=>C,tn=sn({key:null,setSeries:!1,filters:{pub:B_,sub:B_},scales:[A,b[1]?b[1].scale:null],match:[z_,z_,Ip],values:[null,null]},_e.sync);tn.match.length==2&&tn.match.push(Ip),_e.sync=tn;let Lp=tn.key,Au=Fy(Lp);function Bo(_,M,C,L,H,Y,se){tn.filters.pub(_,M,C,L,H,Y,se)&&Au.pub(_,M,C,L,H,Y,se)}Au.sub(n);function Lx(_,M,C,L,H,Y,se){tn.filters.sub(_,M,C,L,H,Y,se)&&Br[_](null,M,C,L,H,Y,se)}n.pub=Lx;function Dx(){Au.unsub(n),qf.delete(n),Pe.clear(),Vf(tu,To,Pp),c.remove(),ne?.remove(),gn("destroy")}n.destroy=Dx;function Ru(){gn("init",i,e),fe(e||i.data,!1),$[A]?vu(A,$[A]):Me(),de=Xt.show&&(Xt.width>0||Xt.height>0),z=pe=!0,Ie(i.width,i.height)}return b.forEach(Hs),w.forEach(_u),t?t instanceof HTMLElement?(t.appendChild(c),Ru()):t(n,Ru):Ru(),n}Mn.assign=sn;Mn.fmtNum=ep;Mn.rangeNum=nu;Mn.rangeLog=ru;Mn.rangeAsinh=jf;Mn.orient=Cr;Mn.pxRatio=St;Mn.join=V1;Mn.fmtDate=np,Mn.tzDate=Q1;Mn.sync=Fy;{Mn.addGap=kA,Mn.clipGaps=lu;let i=Mn.paths={points:Vy};i.linear=Wy,i.stepped=OA,i.bars=BA,i.spline=HA}var du=class{constructor(e){this.curves=e;this.columns=Array.from({length:e.length+1},()=>[])}columns;add(e){let t=e.robot_time[0]??0,n=this.columns[0]??[],s=n[n.length-1];typeof s=="number"&&t<s&&this.columns.forEach(r=>r.length=0),typeof s=="number"&&t-s>.3&&this.columns.forEach((r,o)=>r.push(o===0?(s+t)/2:null)),n.push(t);for(let[r,{value:o}]of this.curves.entries()){let a=o(e);this.columns[r+1]?.push(a===void 0||Number.isNaN(a)?null:a)}n.length>3600*1.1&&(this.columns=this.columns.map(r=>r.slice(-3600)))}data(e,t){let n=this.columns[0],s=(n[n.length-1]??0)-t,r=n.findIndex(o=>o>=s);return[0,...e.map(o=>o+1)].map(o=>(this.columns[o]??[]).slice(Math.max(r,0)))}};var jA=200,QA=[10,30,120],eR=["#2f7fd6","#d9822b","#2ba06a","#b04fc4"];function tR({description:i}){let e=(n,s,r)=>({name:r,value:o=>o[n][s]}),t=n=>({name:"°",value:s=>(s.joint[n]??NaN)*180/Math.PI});return[{title:"Speed, m/s and rad/s",curves:[e("velocity",0,"forward"),e("velocity",1,"left"),e("velocity",2,"turn")]},{title:"Load on the feet, N",curves:[e("foot_force",0,"left"),e("foot_force",1,"right")]},{title:"ZMP along x, m from the base",curves:[e("zmp",0,"measured"),e("planned_zmp",0,"planned"),e("com",0,"CoM")]},{title:"ZMP along y, m from the base",curves:[e("zmp",1,"measured"),e("planned_zmp",1,"planned"),e("com",1,"CoM")]},{title:"Height, m",curves:[e("base_height",0,"base"),e("com",2,"CoM")]},{title:"Age at the robot and way there and back, s",curves:[e("age",0,"joints"),e("age",1,"pose"),e("round_trip",0,"way")]},...i.joints.map(({name:n},s)=>({title:`${n.replaceAll("_"," ")}, °`,curves:[t(s)]}))]}var cp=class{constructor(e,t,n,s){this.plots=e;this.histories=t;this.held=s;let r=O("select",{"aria-label":"What this plot shows"},...e.map(({title:o},a)=>O("option",{value:a},o)));r.value=String(n),r.addEventListener("change",()=>this.choose(Number(r.value))),this.box.append(r),this.chosen=n}box=O("figure");plot;chosen=0;choose(e){this.chosen=e,this.makeAnew()}makeAnew(){this.plot?.destroy(),this.plot=void 0}draw(e){let{curves:t}=this.plots[this.chosen],n=this.histories[this.chosen]?.data(t.map((r,o)=>o),e);this.plot??=this.make(t);let s=this.box.clientWidth;s>0&&s!==this.plot.width&&this.plot.setSize({width:s,height:this.plot.height}),this.plot.setData(n,!this.held())}zoom(e){let{min:t=0,max:n=0}=this.plot?.scales.x??{},s=((t??0)+(n??0))/2,r=((n??0)-(t??0))/2*e;this.plot?.setScale("x",{min:s-r,max:s+r})}make(e){let t=getComputedStyle(this.box),n={stroke:t.color,grid:{stroke:t.getPropertyValue("--line"),width:1},ticks:{stroke:t.getPropertyValue("--line"),width:1}};return new Mn({width:Math.max(this.box.clientWidth,200),height:170,cursor:{drag:{x:!0,y:!1}},scales:{x:{time:!1}},axes:[{...n,values:(s,r)=>r.map(o=>`${o} s`)},{...n,size:52}],series:[{label:"s"},...e.map(({name:s},r)=>({label:s,stroke:eR[r]??"#888",width:1.5}))]},[[],...e.map(()=>[])],this.box)}};function Yy(i){let e=tR(i),t=e.map(({curves:d})=>new du(d)),n=!1,s=!1,r=-1/0,o=[0,1,2].map(d=>new cp(e,t,d,()=>n)),a=O("select",{"aria-label":"How much time is shown"},...QA.map(d=>O("option",{value:d},`${d} s`))),l=Qe("Hold",()=>{n=!n,l.setAttribute("aria-pressed",String(n)),l.textContent=n?"Go on":"Hold"},{"aria-pressed":"false"}),c=d=>()=>{n||l.click(),d()},h=O("div",{class:"tools"},a,l,Qe("Zoom in",c(()=>o.forEach(d=>d.zoom(.5)))),Qe("Zoom out",c(()=>o.forEach(d=>d.zoom(2))))),u=O("p",{class:"hint"},"Drag over a plot to zoom into it while it is held; a double click shows all again.");return matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>o.forEach(d=>d.makeAnew())),i.frameTakers.push(d=>t.forEach(f=>f.add(d))),{title:"Plots",content:O("div",{class:"plots"},h,...o.map(({box:d})=>d),u),show:()=>s=!0,hide:()=>s=!1,look:d=>{!s||n||d-r<jA||(r=d,o.forEach(f=>f.draw(Number(a.value))))}}}var zs=class{list=O("dl",{class:"facts"});values=new Map;set(e,t,n=!1){let s=this.values.get(e);s||(s=O("dd"),this.values.set(e,s),this.list.append(O("div",{},O("dt",{},e),s))),Be(s,t),s.classList.toggle("bad",n)}};var nR=1e4,iR=1e3;function sR(i,e,t,n){let s=c=>t[c],r=t.live,o=s("names").map((c,h)=>{let u=`parameter-${e}-${c}`,d=O("input",{id:u,value:s("values")[h]??"",disabled:!r[h],spellcheck:!1,autocomplete:"off"}),f=O("form",{class:"parameter"},O("label",{for:u},c),d,O("button",{type:"submit",disabled:!r[h]},"Set"),O("small",{},s("docs")[h]??""));return f.addEventListener("submit",g=>{g.preventDefault(),i.attempt(`${e}: ${c} = ${d.value}`,async()=>{i.command.mine||await i.command.take(),await i.robot.order("/plugins/set_parameter",{plugin:e,parameter:c,value:d.value})}).then(n)}),{change:f,live:r[h]??!1}}),a=o.filter(c=>!c.live).map(c=>c.change),l=o.filter(c=>c.live).map(c=>c.change);return O("div",{},...l,O("details",{},O("summary",{},`${a.length} that hold until a restart`),...a))}function rR(i,e,t){let n=e.steps-i.steps,s=n>0?(t-i.seen_s)*1e3/n:NaN;Be(i.state,e.state),i.box.classList.toggle("bad-card",e.state!=="works"),i.facts.set("period",Number.isNaN(s)?"–":`${s.toFixed(1)} ms`),i.facts.set("p50",`${e.p50_step_us.toFixed(0)} µs`),i.facts.set("p99",`${e.p99_step_us.toFixed(0)} µs`),i.facts.set("worst",`${e.worst_step_us.toFixed(0)} µs`),i.facts.set("faults",String(e.faults),e.faults>0),i.facts.set("over budget",String(e.overruns),e.overruns>0)}function Zy(i){let{robot:e,attempt:t,command:n,news:s,freshness:r}=i,o=O("div"),a=O("section",{"aria-label":"Parameters",hidden:!0}),l=new Map,c=-1/0,h=async m=>{let p=await e.order("/plugins/get_parameters",{plugin:m},nR);a.hidden=!1,a.replaceChildren(O("h2",{tabindex:-1},`Parameters of ${m}`),sR(i,m,p,()=>u(m)))},u=m=>void h(m).catch(p=>s.say(p.message,"bad")),d=m=>void h(m).then(()=>a.querySelector("h2")?.focus(),p=>s.say(p.message,"bad")),f=m=>void t(`Reload ${m}`,async()=>{n.mine||await n.take(),await e.order("/plugins/reload",{name:m,library:""},1e4)}),g=({name:m,steps:p},b)=>{let w=O("span",{class:"plugin-state"}),x=new zs,P=O("article",{class:"card","aria-label":m},O("header",{},O("h2",{},m),w,Qe("Parameters",()=>d(m),{"aria-label":`Parameters of ${m}`}),Qe("Reload",()=>f(m),{"aria-label":`Reload ${m}`})),x.list);o.append(P);let A={box:P,state:w,facts:x,steps:p,seen_s:b};return l.set(m,A),A},y=async()=>{let{plugins:m}=await e.order("/plugins/list"),p=r.newest?.robot_time[0]??0;for(let b of m){let w=l.get(b.name)??g(b,p);b.steps<w.steps&&Object.assign(w,{steps:b.steps,seen_s:p}),rR(w,b,p)}};return{title:"Plug-ins",content:O("div",{class:"plugins"},o,a),look:m=>{!e.isOpen||m-c<iR||(c=m,y().catch(p=>s.say(p.message,"bad")))}}}function oR(i){return i<1e6?`${Math.ceil(i/1e3)} kB`:`${(i/1e6).toFixed(1)} MB`}var aR=1e3;function Ky({robot:i,attempt:e,news:t}){let n=O("input",{id:"recording-name",placeholder:"named by the time",pattern:"[A-Za-z0-9_.\\-]*",maxlength:100}),{table:s,body:r}=Ui("Recordings (MCAP), the newest first","file","size","begun"),o=O("p",{class:"hint path"}),a=new Map,l=-1/0,c=({file:m,bytes:p})=>{let b=a.get(m);return a.set(m,p),`${oR(p)}${b!==void 0&&p>b?", recording":""}`},h=async()=>{l=performance.now();let m=await i.order("/recording/list"),p=m.recordings;r.replaceChildren(...p.map(w=>al(O("span",{class:"path",title:w.file},w.file.split("/").pop()??w.file),c(w),new Date(w.start.sec*1e3).toLocaleString())));let b=p[0]?.file.replace(/\/[^/]*$/,"");Be(o,b===void 0?"There are none yet.":`On the robot's computer, in ${b}. ${m.message}`)},u=()=>void h().catch(m=>t.say(m.message,"bad")),d=()=>void e("Recording",()=>i.order("/recording/start",{name:n.value}),"begun").then(u),f=Qe("Record",d),g=Qe("End the recording",()=>void e("Recording",()=>i.order("/recording/stop",{},1e4),"ended").then(u));return n.addEventListener("keydown",m=>m.key==="Enter"&&d()),{title:"Recordings",content:O("div",{class:"recordings"},O("div",{class:"tools"},O("label",{for:"recording-name"},"Name"),n,f,g),s,o),show:u,look:m=>{i.isOpen&&m-l>aR&&h().catch(()=>{})}}}async function jy(i){let e=await fetch("bus.json",Ji(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var lR=2147483648,cR=1073741824,hR=536870912;function uR(i){return`0x${i.toString(16).toUpperCase().padStart(3,"0")}`}function Qy(i,e){return i.joint<0?i.kind:`${i.kind}, ${e[i.joint]??`joint ${i.joint}`}`}function dR(i){return`unknown ${(i&lR)!==0?"extended ":""}${(i&cR)!==0?"remote ":""}frame ${uR(i&536870911)}`}var hp=class{constructor(e,t,n){this.slot=e;this.table=t;this.frames=n;this.sync=n.find(({message:s})=>s.released==="slot_edge")}sync;ofMissing(e){if(e.released==="slot_edge")return 0;if(e.released==="sync")return this.sync?.end_us??this.table.messages.find(({released:t})=>t==="slot_edge")?.worst_us??void 0}of(e){let{message:t,start_us:n}=e;switch(t.released){case"sync":return this.answersNothingHere(e)?void 0:this.ofMissing(t);case"cycle_edge":return this.slot.slot===0?0:void 0;case"batch":return this.frames.find(s=>s.message.released==="batch"&&Jy(s)===Jy(e))?.start_us;case"trajectory":return this.frames.findLast(s=>s.message.joint===t.joint&&s.message.released==="cycle_edge"&&s.end_us<=n)?.end_us;default:return this.ofMissing(t)}}answersNothingHere({start_us:e}){return this.sync!==void 0&&e<this.sync.end_us}isOfSlotBefore(e){return e.message.released==="sync"&&this.answersNothingHere(e)&&this.frames.some(t=>t.message===e.message&&t.end_us>e.end_us)}};function Jy({message:i,id:e}){return i.ids.indexOf(e)}function fR(i,e,t){let{message:n,end_us:s,start_us:r}=i,o=e.of(i),a=o===void 0||n.worst_us===null?void 0:o+n.worst_us,c=e.isOfSlotBefore(i)||a!==void 0&&s>a?"late":a===void 0?"seen":"in time";return{message:n,name:Qy(n,t),verdict:c,end_us:s,length_us:s-r,...o!==void 0&&{due_us:o},...a!==void 0&&{latest_us:a}}}function pR(i,e){return!i.on_event&&i.period_us===e.slot_us&&(i.released==="slot_edge"||i.released==="sync")}function ex(i,e,t){let n=new Map(e.messages.flatMap(u=>u.ids.map(d=>[d,u]))),s=[],r=[],o=0;for(let[u,d]of i.id.entries()){let[f,g]=[i.end_us[u]??0,i.length_us[u]??0],y=n.get(d);if((d&hR)!==0){s.push({name:"error on the bus",verdict:"error",end_us:f,length_us:0});continue}o+=Math.min(g,f)+e.interframe_us,y?r.push({message:y,id:d,start_us:f-g,end_us:f}):s.push({name:dR(d),verdict:"foreign",end_us:f,length_us:g})}r.sort((u,d)=>u.end_us-d.end_us);let a=new hp(i,e,r);s.push(...r.map(u=>fR(u,a,t)));let l=new Set(r.filter(u=>!a.isOfSlotBefore(u)).map(({message:u})=>u));for(let u of i.left_out>0?[]:e.messages){let d=a.ofMissing(u);l.has(u)||d===void 0||!pR(u,e)||s.push({message:u,name:Qy(u,t),verdict:"missing",length_us:u.transmission_us,due_us:d,...u.worst_us!==null&&{latest_us:d+u.worst_us}})}let c=({end_us:u,due_us:d})=>u??d??0;s.sort((u,d)=>c(u)-c(d));let h={"in time":0,seen:0,late:0,missing:0,foreign:0,error:0};for(let{verdict:u}of s)h[u]+=1;return{entries:s,load:Math.min(o/e.slot_us,1),count:h}}function up({entries:i,load:e}){return`${i.filter(({end_us:n,verdict:s})=>n!==void 0&&s!=="error").length} frames take ${Math.round(e*100)} % of the slot`}function dp({entries:i,count:e}){let t=s=>{let r=i.filter(o=>o.verdict===s).map(({name:o})=>o);return r.length>2?`${r.slice(0,2).join("; ")} …`:r.join("; ")},n=[e.missing>0&&`${e.missing} missing (${t("missing")})`,e.late>0&&`${e.late} late (${t("late")})`,e.error>0&&`${e.error} ${e.error===1?"error":"errors"}`,e.foreign>0&&`${e.foreign} not the robot's own (${t("foreign")})`].filter(s=>s!==!1);return n.length>0?n.join(", "):"none is missing or late"}var tx=({count:i})=>i.missing+i.late+i.error+i.foreign>0;var ni=14,mR=18,gR=5.7,nx=22,_R=12,yR=280,xR=2e3,ix=1500,vR={SYNC:"sync",trim:"trim",feedback:"feedback",trajectory:"trajectory"},bR=[["sync","SYNC"],["trim","trim"],["feedback","feedback"],["trajectory","trajectory"],["other","other"],["due","due"],["latest","proven latest"],["late","late"],["missing","missing"],["error","error"],["foreign","foreign"]];function pi(i,e,t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,typeof r=="number"?String(Math.round(r*10)/10):r);return t!==void 0&&(n.textContent=t),n}var fu=i=>i===void 0?"–":(i/1e3).toFixed(2);function wR({name:i,verdict:e,end_us:t,length_us:n,latest_us:s}){let r=t===void 0?"has not come":`at ${fu(t)} ms`;return[`${i}: ${r}`,n>0&&t!==void 0&&`${n} µs long`,s!==void 0&&`at the latest ${fu(s)} ms`,e!=="seen"&&e].filter(Boolean).join(", ")}var pu=class{constructor(e,t){this.bus=e;this.joints=t;let n=[...new Set(e.messages.map(({joint:a})=>a).filter(a=>a>=0))].sort((a,l)=>a-l);for(let[a,l]of n.entries())this.jointLane.set(l,a+1);this.lanes=["all joints",...n.map(a=>t[a]??""),"others, errors"].map(a=>a.length>nx?`${a.slice(0,nx-1)}…`:a),this.label_px=Math.max(...this.lanes.map(({length:a})=>a))*gR+10;let{table:s,body:r}=Ui("Frames of the slot; times in ms from its edge","frame","end","µs","at the latest","");s.classList.add("bus-table"),this.rows=r,this.details=O("details",{},O("summary",{},"The slot as a table"),s),this.details.addEventListener("toggle",()=>this.fillTable()),this.box.append(this.drawing);let o=O("ul",{class:"bus-legend","aria-hidden":!0},...bR.map(([a,l])=>O("li",{class:a},l)));this.content=O("div",{},O("div",{class:"tools"},this.hold,this.status),this.box,this.verdict,o,O("p",{class:"note"},this.note()),this.details),new ResizeObserver(()=>this.draw()).observe(this.box)}drawing=pi("svg",{role:"img"});status=O("p",{class:"bus-status"});verdict=O("p",{class:"bus-verdict"});hold=Qe("Hold",()=>this.toggle());rows;details;lanes;label_px;jointLane=new Map;box=O("div",{class:"bus-picture"});shown;slot;held=!1;content;take(e){this.held||(this.slot=e,this.shown=ex(e,this.bus,this.joints),Be(this.verdict,dp(this.shown)),this.verdict.classList.toggle("bad",tx(this.shown)),this.draw(),this.fillTable())}look(e,t){if(!this.slot||!this.shown){Be(this.status,"No slot has come yet.");return}let{sec:n,nanosec:s}=this.slot.header.stamp,r=e-n*1e3-s/1e6,o=r<-ix?NaN:Math.max(r,0),a=!t||Number.isNaN(o)||o>ix;this.box.classList.toggle("old",a&&!this.held);let l=this.held?"held, ":a?"old: ":"";Be(this.status,`Slot ${this.slot.slot} of cycle ${this.slot.cycle}, ${l}${Number.isNaN(o)?"of unknown age":`${oi(o)} ago`}. ${up(this.shown)}.`)}note(){let{profile:e,load:t,jitter_us:n,jam_us:s}=this.bus;return`One slot of 25. Proven for the profile '${e}': load ${Math.round(t*100)} % at most; latest arrivals with senders up to ${n/1e3} ms late and the bus jammed once for ${s/1e3} ms.`}toggle(){this.held=!this.held,this.hold.setAttribute("aria-pressed",String(this.held))}laneOf({message:e}){return e?e.joint<0?0:this.jointLane.get(e.joint)??this.lanes.length-1:this.lanes.length-1}draw(){let e=Math.max(this.box.clientWidth,yR);if(!this.shown||this.box.clientWidth===0)return;let t=this.lanes.length*ni+mR,{slot_us:n}=this.bus,s=r=>this.label_px+Math.min(Math.max(r,0),n)/n*(e-this.label_px-_R);this.drawing.setAttribute("viewBox",`0 0 ${e} ${t}`),this.drawing.setAttribute("height",String(t)),this.drawing.setAttribute("aria-label",`${up(this.shown)}: ${dp(this.shown)}`),this.drawing.replaceChildren(...this.ground(s,e),...this.dueLine(s),...this.shown.entries.flatMap(r=>this.marks(r,s)))}ground(e,t){let n=this.lanes.length*ni,s=this.lanes.flatMap((r,o)=>[pi("rect",{class:o%2===0?"lane even":"lane",x:0,y:o*ni,width:t,height:ni}),pi("text",{x:this.label_px-6,y:(o+1)*ni-3.5,"text-anchor":"end"},r)]);for(let r=0;r<=this.bus.slot_us;r+=xR)s.push(pi("line",{class:"grid",x1:e(r),x2:e(r),y1:0,y2:n}),pi("text",{x:r===this.bus.slot_us?t:e(r),y:n+13,"text-anchor":r===this.bus.slot_us?"end":"middle"},`${r/1e3}${r===this.bus.slot_us?" ms":""}`));return s}dueLine(e){let t=this.shown?.entries.find(({message:n,due_us:s})=>n?.released==="sync"&&s!==void 0)?.due_us;return t===void 0?[]:[pi("line",{class:"due",x1:e(t),x2:e(t),y1:ni,y2:(this.lanes.length-1)*ni})]}marks(e,t){let{message:n,verdict:s,end_us:r,length_us:o,due_us:a,latest_us:l}=e,c=this.laneOf(e)*ni,h=[];return l!==void 0&&l<=this.bus.slot_us&&h.push(pi("line",{class:"latest",x1:t(l),x2:t(l),y1:c+1,y2:c+ni-1})),r===void 0?h.push(pi("text",{class:"missing",x:t(a??0)+4,y:c+ni-3.5},"✕ missing")):s==="error"?h.push(pi("text",{class:"error",x:t(r),y:c+ni-3,"text-anchor":"middle"},"◆")):h.push(...this.block(t(r-o),t(r),c,s,n)),h.at(-1)?.append(pi("title",{},wR(e))),h}block(e,t,n,s,r){let o=s==="foreign"?"foreign":vR[r?.kind??""]??"other",a=pi("rect",{class:`frame ${o}${s==="late"?" late":""}`,x:e,y:n+2,width:Math.max(t-e,1.5),height:ni-4});return s!=="late"?[a]:[pi("text",{class:"late",x:e-2,y:n+ni-3.5,"text-anchor":"end"},"late"),a]}fillTable(){!this.details.open||!this.shown||this.rows.replaceChildren(...this.shown.entries.map(e=>{let{name:t,end_us:n,length_us:s,latest_us:r,verdict:o}=e,a=al(t,fu(n),n===void 0?"–":String(s),fu(r),o);for(let l of[1,2,3])a.cells[l]?.classList.add("number");return a.classList.toggle("bad",o!=="in time"&&o!=="seen"),a}))}};async function sx(i){let e=await fetch("calibration.json",Ji(i));if(!e.ok)throw new Error(await e.text());return await e.json()}var mu=i=>i*180/Math.PI,MR=(i,e)=>(i<0?"−":"+")+Math.abs(i).toFixed(e),SR="as described";function fp(i,e,t,n){if(!i)return SR;let s=i.deviation?.[e];return MR(t(i.value[e]??NaN),n)+(s===void 0?"":` ± ${t(s).toFixed(n)}`)}var rx=i=>fp(i,0,mu,3),ox=(i,e)=>fp(i,e,t=>t*1e3,1),ax=(i,e)=>fp(i,e,t=>t,3).replace(/^\+/,"");function lx([i,e,t,n]){let s=2*(n*e-t*i),r=Math.abs(s)>1-1e-9,o=r?0:Math.atan2(2*(n*i+e*t),1-2*(i*i+e*e)),a=Math.asin(Math.min(1,Math.max(-1,s))),l=r?-2*Math.sign(s)*Math.atan2(i,n):Math.atan2(2*(n*t+i*e),1-2*(e*e+t*t));return[mu(o),mu(a),mu(l)].map(c=>Math.abs(c)<5e-4?0:c)}function cx({there:i,made:e}){return i?e===null?"Calibrated; its file does not say when.":`Calibrated, made ${e.replace("T"," ").replace(/:\d\dZ$/," UTC")}.`:"This robot has no calibration: zeros, centre of mass and gains are taken to be as its description says. gaitway calibrate finds them."}var ER=["front left","front right","rear left","rear right"],pp=i=>O("th",{scope:"row"},i),Qa=i=>O("td",{class:"number"},i);function TR({joints:i}){let{table:e,body:t}=Ui("Joint zeros: what an encoder says where its joint is at 0","joint","zero, °","trim channel");e.classList.add("zeros");for(let{name:n,zero:s,trim_channel:r}of i)t.append(O("tr",{},pp(n.replaceAll("_"," ")),Qa(rx(s)),Qa(r===null?"–":String(r))));return e}function AR({feet:i}){if(i.every(({sensor:n})=>n!=="cells"))return O("p",{class:"hint"},"Its feet have no force cells.");let{table:e,body:t}=Ui("Force cells: reading over force; each is taken to read 0 N without load","cell","left","right");e.classList.add("gains");for(let[n,s]of ER.entries())t.append(O("tr",{},pp(s),...i.map(({gain:r,sensor:o})=>Qa(o==="cells"?ax(r,n):"–"))));return e}function RR({trunk_com_offset:i,imu:e}){let{table:t,body:n}=Ui(`Trunk and IMU (in ${e.link})`,"axis","centre of mass off by, mm","IMU turned by, °");t.classList.add("trunk");let s=lx(e.turn);for(let[r,o]of["x, roll","y, pitch","z, yaw"].entries())n.append(O("tr",{},pp(o),Qa(ox(i,r)),Qa((s[r]??NaN).toFixed(2))));return t}function hx({token:i,news:e}){let t=O("div"),n=O("details",{class:"calibration"},O("summary",{},"Calibration"),t),s=!1;return n.addEventListener("toggle",()=>{!n.open||s||(s=!0,sx(i()).then(r=>t.replaceChildren(O("p",{},cx(r)),TR(r),AR(r),RR(r)),r=>{s=!1,n.open=!1,e.say(`The calibration does not come: ${r.message}`,"bad")}))}),n}function CR(i){let{table:e,body:t}=Ui("Joints","joint","position, °","torque, N·m","faults");e.classList.add("joints");let n=i.description.joints.map(({name:s})=>{let[r,o]=[O("td",{class:"number"}),O("td",{class:"number"})],a=O("td"),l=O("tr",{},O("th",{scope:"row"},s.replaceAll("_"," ")),r,o,a);return t.append(l),{row:l,position:r,torque:o,faults:a}});return{table:e,joints:n}}function PR({freshness:i},e,t,n,s){let r=i.newest;if(!r)return;n.set("late",String(r.batches_late[0]),(r.batches_late[0]??0)>0),n.set("refused",String(r.batches_refused[0]),(r.batches_refused[0]??0)>0),n.set("cycles from a safe tail",String(r.tails_played[0])),n.set("robot's clock",`${(r.robot_time[0]??0).toFixed(1)} s`);for(let[c,h]of pl.entries()){let u=i.age_ms(c,t);s.set(h,oi(u),c!==3&&u>300)}s.set("way there and back",Number.isNaN(r.round_trip[0])?"–":oi((r.round_trip[0]??0)*1e3));let{frames:o,outages:a,longest_ms:l}=i.loss;s.set("lost by this page",`${o} frames, ${a} outages${a>0?`, the longest ${oi(l)}`:""}`,a>0),s.set("pictures",`${e.pace.perSecond} /s, ${e.pace.total} in all`)}function IR(i){let{robot:e,freshness:t,description:n}=i,s=O("div",{},O("p",{class:"note"},"The robot is asked what its bus is meant to carry.")),r,o,a=async()=>{try{r=new pu(await jy(i.token()),n.joints.map(({name:l})=>l.replaceAll("_"," "))),s.replaceChildren(r.content)}catch(l){s.replaceChildren(O("p",{class:"note bad"},`What the bus is meant to carry does not come: ${l.message}`)),o=void 0}};return{content:s,show:()=>{let[l,c]=[!0,()=>{}];return o??=a(),o.then(()=>{r&&l&&(c=e.subscribe("/bus_slot","gaitway_msgs/msg/BusSlot",0,h=>r?.take(h)))}),()=>{l=!1,c()}},look:l=>r?.look((t.newest?.robot_time[0]??NaN)*1e3+t.age_ms(4,l),t.state(l)==="live")}}function ux(i,e){let{robot:t,freshness:n,description:s}=i,[r,o,a]=[new zs,new zs,new zs],l=IR(i),{table:c,joints:h}=CR(i),u=O("div",{class:"state"},O("h2",{},"Batches"),r.list,O("h2",{},"Age of what is shown"),o.list,O("h2",{},"Bus"),a.list,O("h2",{},"A time slot on the bus"),l.content,c,hx(i)),d=new Map,f=[],g=m=>{for(let[p,b]of m.effort.entries()){let w=Math.abs(b)/(s.joints[p]?.torque??1/0),x=h[p]?.torque;x&&(Be(x,b.toFixed(2)),x.classList.toggle("bad",w>.95))}},y=m=>{let p=m.status;d=new Map(p.find(({name:P})=>P==="nodes")?.values.map(({key:P,value:A})=>[P,A]));let{message:b="",level:w=0,values:x=[]}=p.find(({name:P})=>P==="bus")??{};a.set("state",b,w>0);for(let{key:P,value:A}of x)(A!=="0"||P.endsWith("_errors"))&&a.set(P.replaceAll("_"," "),A)};return{title:"State",content:u,show:()=>{f=[t.subscribe("/joint_states","sensor_msgs/msg/JointState",250,g),t.subscribe("/diagnostics","diagnostic_msgs/msg/DiagnosticArray",0,y),l.show()]},hide:()=>f.forEach(m=>m()),look:m=>{PR(i,e,m,r,o),l.look(m);for(let[p,b]of h.entries()){let w=n.newest?.joint[p];Be(b.position,w===void 0?"–":(w*180/Math.PI).toFixed(1));let x=n.newest!==void 0&&Kp(n.newest,p);Be(b.faults,x?d.get(s.joints[p]?.name??"")??"fault":""),b.row.classList.toggle("bad",x)}}}}function dx(i){let e=ft("token"),t=ft("token-text");return Be(ft("token-why"),i),t.value="",new Promise(n=>{e.oncancel=s=>s.preventDefault(),e.onclose=()=>{t.value===""?e.showModal():n(t.value.trim())},e.showModal(),t.focus()})}var el="1fcc56f36e71ecaa";async function fx(){let i=await fetch("version.json",{cache:"no-store",signal:AbortSignal.timeout(2e3)});if(i.status===404)return"";if(!i.ok)throw new Error(await i.text());return String((await i.json()).page??"")}function px(i){let e=i===""?"an older page, without a version":`page ${i}`;return`This page is of another version than the robot's software: this is page ${el}, the robot has ${e}. It is not understood any more: load the page again. Stop still works.`}var LR="the token is wrong",gu=class{constructor(e,t,n){this.freshness=t;this.token=n;this.keeper=new zr(`${e}?page=${el}`,this)}keeper;since_ms=performance.now();open=!1;onFrame=()=>{};onWrongToken=()=>{};onWrongVersion=()=>{};start(){this.keeper.start(),setInterval(()=>this.look(),1e3/4)}opened(e){this.open=!0,this.since_ms=performance.now();let t=this.token();t!==void 0&&e.send(t)}closed(e){this.open||this.askForVersion(),this.open=!1,e===LR&&(this.keeper.stop(),this.onWrongToken()),this.freshness.disconnected(performance.now())}received(e){try{let t=Yp(e);this.keeper.send(Zp(t)),this.since_ms=performance.now(),this.freshness.take(t,this.since_ms),this.onFrame(t)}catch(t){if(!(t instanceof Vo))throw t;this.endFor(`${t.message}: load the page again. Stop still works.`)}}async askForVersion(){let e=await fx().catch(()=>el);e!==el&&this.endFor(px(e))}endFor(e){this.keeper.stop(),this.onWrongVersion(e)}look(){this.open&&performance.now()-this.since_ms>1e3&&this.keeper.restart("nothing came")}};var DR=100,NR=500,Pr;async function kR(i){for(;;)try{return await zp(Pr)}catch(e){if(e instanceof zo){Pr=await dx(Pr===void 0?"Whoever serves it can tell you.":"That was not the right one.");continue}i.say(`The robot's description does not come: ${e.message}`,"bad"),await new Promise(t=>setTimeout(t,NR))}}function FR(i){return async(e,t,n="done")=>{try{return await t(),i.say(`${e}: ${n}`,"good",e),!0}catch(s){let r=s instanceof Ys?" Look whether it was carried out: it is not sent again.":"";return i.say(`${e}: ${s.message}${r}`,"bad",e),!1}}}function UR(i,e,t,n,s,r,o){let{freshness:a,robot:l,news:c,description:h}=i,u=new gu(Cu("/view"),a,()=>Pr),d=new $h(i),f=new Yh(ft("tabs"),ft("panels"),o);i.frameTakers.push(b=>t.show(b),b=>r.show(b)),u.onFrame=b=>i.frameTakers.forEach(w=>w(b));let g=new _l(l),m=h.bounds.push!==void 0?l_(i,{scene:t,canvas:n,tools:s,tabs:f,stops:r,banner:g}):void 0;u.onWrongVersion=b=>{e.retire();for(let w of["top","camera","panel"])ft(w).inert=!0;g.otherVersion(b)},u.onWrongToken=()=>location.reload(),l.onClose=()=>e.lost(),l.onStatus=(b,w)=>{if(b==="error"&&Op(w)){e.late(performance.now());return}b==="error"&&i.drive.end(),!Bp(w)&&c.say(b==="error"?`What you asked for was not done: ${w}`:w,b==="error"?"bad":"plain")},setInterval(()=>{let b=performance.now();d.look(b),g.look(b),f.look(b),m?.(b),t.setOld(a.state(b)!=="live")},DR),u.start(),l.start()}async function OR(){let i=new yl(ft("news")),e=await kR(i),t=ft("scene"),n=new wh(t,e);n.onDrawn=()=>{performance.getEntriesByName("first-picture").length===0&&performance.mark("first-picture")};let s=new ll(Cu("/"),()=>Pr),r=`page ${crypto.getRandomValues(new Uint16Array(1))[0]?.toString(16).padStart(4,"0")}`,o={description:e,freshness:new gl,robot:s,command:new cl(s,r),drive:new hl,news:i,token:()=>Pr,frameTakers:[],attempt:FR(i)},a=new ml(o),l=new qh(o,()=>a.end());a.pad.onStop=()=>l.stop();let{push:c}=e.bounds,h=new xl,u=c&&new vl(o,n,t,c,h);u&&h.add(u),Np(ft("camera"),n,u);let d=[y_(o,a),ux(o,n),Yy(o),b_(o),Zy(o),Ky(o)];UR(o,a,n,t,h,l,d),await n.body.loadMeshes(Pr,()=>n.ask())}OR();})();
